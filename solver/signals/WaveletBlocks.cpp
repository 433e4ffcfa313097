// The block engine of the continuous wavelet transform. In the frequency domain equation 1 reads
//   W(s, tau) = (1/2 pi) Integral X(w) sqrt(s) Psi*(s w) exp(i w tau) dw,
//   Psi(w) = pi^(-1/4) sqrt(2 pi) exp(-(w - w0)^2/2),
// a Gaussian band around w0/s. Only the bins inside the band are taken, and a band of K bins needs an inverse transform
// of K points only: that gives the low voices at a stride and is what makes the transform cheap.
#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <numbers>
#include <sstream>
#include <thread>

#include "signals/ContinuousWavelet.h"
#include "signals/FourierTransform.h"
#include "signals/SignalError.h"

namespace squat::signals {
namespace {

// Half width of the wavelet that counts, in scales (time) and in 1/scales (frequency): exp(-6.8^2/2) = 9e-11.
constexpr double halfWidth = 6.8;
// Shortest block: transforms of this length and below stay inside a core's second-level cache.
constexpr std::size_t shortestBlock = std::size_t{1} << 15;

struct Voice {
  std::size_t stride;           // samples per coefficient
  long firstBin;                // may be negative: bins of negative frequency
  std::vector<double> weights;  // of the bins firstBin, firstBin + 1, ..
  std::size_t plan;             // index of the inverse transform
};

struct BlockLayout {
  std::size_t block;   // samples of a transform, a power of two
  std::size_t margin;  // samples at each end that the neighbours of the block spoil
  std::size_t inner;   // samples that a block yields
};

void requireFrequencies(const std::vector<double>& frequencies, double rate) {
  for (const double frequency : frequencies) {
    if (frequency > 0 && frequency <= rate / 2 * (1 + 1e-12)) continue;
    std::ostringstream text;
    text << "a wavelet at " << frequency << " Hz needs a sampling rate of at least " << 2 * frequency
         << " Hz; this one is " << rate << " Hz";
    throw SignalError(text.str());
  }
}

BlockLayout blockLayout(std::size_t samples, double largestScale, double step) {
  const auto margin = static_cast<std::size_t>(std::ceil(halfWidth * largestScale / step)) + 1;
  // One block where the record is short; else blocks of at least eight margins, so that at most a quarter is waste.
  const std::size_t whole = std::bit_ceil(samples + 2 * margin);
  const std::size_t block = std::min(whole, std::bit_ceil(std::max(shortestBlock, 8 * margin)));
  return {block, margin, block - 2 * margin};
}

Voice makeVoice(double scale, double step, WaveletNormalisation normalisation, const BlockLayout& layout,
                std::size_t largestStride) {
  const double block = static_cast<double>(layout.block);
  const double binWidth = 2 * std::numbers::pi / (block * step);  // [rad/s]
  const long half = static_cast<long>(layout.block / 2);
  Voice voice{};
  voice.firstBin =
      std::max(-half + 1, static_cast<long>(std::ceil((morletFrequency - halfWidth) / (scale * binWidth))));
  const long lastBin =
      std::min(half, static_cast<long>(std::floor((morletFrequency + halfWidth) / (scale * binWidth))));
  const double peak = normalisation == WaveletNormalisation::amplitude
                          ? 2.0
                          : std::sqrt(2 * std::numbers::pi * scale) / std::sqrt(std::sqrt(std::numbers::pi));
  for (long k = voice.firstBin; k <= lastBin; ++k) {
    const double distance = scale * binWidth * static_cast<double>(k) - morletFrequency;
    double weight = peak * std::exp(-0.5 * distance * distance) / block;
    if (k == half) weight *= 0.5;  // the bin at half the rate holds both its signs
    voice.weights.push_back(weight);
  }
  voice.stride = 1;
  const std::size_t bins = std::max<std::size_t>(voice.weights.size(), 2);
  while (voice.stride * 2 <= largestStride && layout.block / (voice.stride * 2) >= bins) voice.stride *= 2;
  return voice;
}

// Hands the parts of each voice on in the order of the blocks, one at a time: sums over cells that two blocks share do
// not depend on which thread was first. The earliest block under way never waits.
class InOrder {
 public:
  InOrder(std::size_t voices, const WaveletSink& sink) : sink_(sink), delivered_(voices, 0) {}

  void deliver(std::size_t block, const WaveletPart& part) {
    std::unique_lock lock(mutex_);
    turn_.wait(lock, [&] { return failed_ || delivered_[part.voice] == block; });
    if (failed_) return;
    sink_(part);
    ++delivered_[part.voice];
    lock.unlock();
    turn_.notify_all();
  }
  // Nobody waits any longer, nothing more is handed on.
  void fail() {
    {
      const std::lock_guard lock(mutex_);
      failed_ = true;
    }
    turn_.notify_all();
  }

 private:
  const WaveletSink& sink_;
  std::vector<std::size_t> delivered_;  // blocks of each voice
  bool failed_ = false;
  std::mutex mutex_;
  std::condition_variable turn_;
};

// What one thread needs for a block.
struct Workspace {
  explicit Workspace(std::size_t block) : samples(block), bins(block / 2 + 1), coefficients(block) {}
  std::vector<double> samples;
  std::vector<Complex> bins, coefficients;
};

class BlockTransform {
 public:
  BlockTransform(const TimeSeries& series, const std::vector<double>& frequencies, WaveletNormalisation normalisation,
                 std::size_t largestStride)
      : series_(series),
        layout_(blockLayout(series.values.size(),
                            waveletScale(*std::min_element(frequencies.begin(), frequencies.end()), normalisation),
                            series.step)),
        forward_(layout_.block) {
    std::vector<std::size_t> strides;
    for (const double frequency : frequencies) {
      voices_.push_back(
          makeVoice(waveletScale(frequency, normalisation), series.step, normalisation, layout_, largestStride));
      auto& voice = voices_.back();
      voice.plan = static_cast<std::size_t>(std::find(strides.begin(), strides.end(), voice.stride) - strides.begin());
      if (voice.plan == strides.size()) {
        strides.push_back(voice.stride);
        backward_.emplace_back(layout_.block / voice.stride, Direction::backward);
      }
    }
    // Blocks begin on multiples of the largest stride, so that the coefficients of a voice are equally spaced.
    const std::size_t grid = *std::max_element(strides.begin(), strides.end());
    layout_.margin = (layout_.margin + grid - 1) / grid * grid;
    layout_.inner = layout_.block > 2 * layout_.margin ? (layout_.block - 2 * layout_.margin) / grid * grid : 0;
    if (layout_.inner == 0) throw SignalError("the wavelet transform's block is too short for its lowest frequency");
  }

  std::size_t block() const { return layout_.block; }
  std::size_t blocks() const { return (series_.values.size() + layout_.inner - 1) / layout_.inner; }

  void run(std::size_t index, Workspace& work, InOrder& parts) const {
    const std::size_t first = index * layout_.inner;
    const std::size_t last = std::min(series_.values.size(), first + layout_.inner);
    // The block begins `margin` before `first`; outside the record the signal is zero.
    std::fill(work.samples.begin(), work.samples.end(), 0.0);
    const std::size_t from = first > layout_.margin ? first - layout_.margin : 0;
    const std::size_t to = std::min(series_.values.size(), first + layout_.block - layout_.margin);
    std::copy(series_.values.begin() + static_cast<std::ptrdiff_t>(from),
              series_.values.begin() + static_cast<std::ptrdiff_t>(to),
              work.samples.begin() + static_cast<std::ptrdiff_t>(layout_.margin + from - first));
    forward_.forward(work.samples.data(), work.bins.data());
    for (std::size_t v = 0; v < voices_.size(); ++v) {
      const Voice& voice = voices_[v];
      transformVoice(voice, work);
      const std::size_t count = (last - first + voice.stride - 1) / voice.stride;
      parts.deliver(index, {v, first, voice.stride, {work.coefficients.data() + layout_.margin / voice.stride, count}});
    }
  }

 private:
  void transformVoice(const Voice& voice, Workspace& work) const {
    const std::size_t points = layout_.block / voice.stride;
    std::fill_n(work.coefficients.begin(), points, Complex(0, 0));
    const long mask = static_cast<long>(points) - 1;  // points is a power of two: k & mask is k modulo points
    const auto bins = static_cast<long>(voice.weights.size());
    for (long i = 0; i < bins; ++i) {
      const long k = voice.firstBin + i;
      const Complex bin =
          k >= 0 ? work.bins[static_cast<std::size_t>(k)] : std::conj(work.bins[static_cast<std::size_t>(-k)]);
      work.coefficients[static_cast<std::size_t>(k & mask)] += voice.weights[static_cast<std::size_t>(i)] * bin;
    }
    backward_[voice.plan].inPlace(work.coefficients.data());
  }

  const TimeSeries& series_;
  BlockLayout layout_;
  RealTransform forward_;
  std::vector<ComplexTransform> backward_;
  std::vector<Voice> voices_;
};

}  // namespace

void transformInBlocks(const TimeSeries& series, const std::vector<double>& frequencies,
                       WaveletNormalisation normalisation, std::size_t largestStride, int threads,
                       const WaveletSink& sink) {
  requireUsable(series, 2, "a wavelet transform");
  if (frequencies.empty()) throw SignalError("a wavelet transform needs at least one frequency");
  requireFrequencies(frequencies, series.rate());
  const BlockTransform transform(series, frequencies, normalisation, std::max<std::size_t>(largestStride, 1));

  InOrder parts(frequencies.size(), sink);
  std::mutex errorMutex;
  std::exception_ptr error;
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    try {
      Workspace workspace(transform.block());
      for (std::size_t i = next++; i < transform.blocks(); i = next++) transform.run(i, workspace, parts);
    } catch (...) {
      const std::lock_guard lock(errorMutex);
      if (!error) error = std::current_exception();
      next = transform.blocks();
      parts.fail();
    }
  };
  const std::size_t wanted = std::min<std::size_t>(static_cast<std::size_t>(std::max(threads, 1)), transform.blocks());
  std::vector<std::jthread> helpers;
  for (std::size_t t = 1; t < wanted; ++t) helpers.emplace_back(work);
  work();
  helpers.clear();
  if (error) std::rethrow_exception(error);
}

}  // namespace squat::signals
