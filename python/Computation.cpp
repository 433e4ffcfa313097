#include "python/Computation.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/Errors.h"
#include "text/Numbers.h"

namespace squat::python {

namespace py = pybind11;

namespace {

constexpr auto betweenLooks = std::chrono::milliseconds(20);  // for signals: Ctrl-C feels immediate
constexpr int threadsOfACore = 4, anyMachine = 8;             // at most, as the command line has it

struct News {
  std::vector<std::pair<std::string, double>> reports;  // phase and its fraction
  std::vector<std::string> messages;
  bool isDone = false;
};

// What the computing thread leaves for the waiting one.
class Mailbox : public Monitor {
 public:
  void report(const Progress& progress) override {
    const std::lock_guard lock(mutex_);
    const auto same = std::find_if(news_.reports.begin(), news_.reports.end(),
                                   [&](const auto& report) { return report.first == progress.phase; });
    if (same != news_.reports.end())
      same->second = progress.fraction;
    else
      news_.reports.emplace_back(progress.phase, progress.fraction);
    hasNews_.notify_one();
  }
  void message(const std::string& text) override {
    const std::lock_guard lock(mutex_);
    news_.messages.push_back(text);
    hasNews_.notify_one();
  }
  bool cancelled() override { return isCancelled_.load(std::memory_order_relaxed); }

  void cancel() { isCancelled_ = true; }
  void end() {
    const std::lock_guard lock(mutex_);
    news_.isDone = true;
    hasNews_.notify_one();
  }
  News await() {
    std::unique_lock lock(mutex_);
    hasNews_.wait_for(lock, betweenLooks, [&] { return news_.isDone || !news_.reports.empty(); });
    News news = std::move(news_);
    news_ = {};
    return news;
  }

 private:
  std::mutex mutex_;
  std::condition_variable hasNews_;
  News news_;
  std::atomic<bool> isCancelled_{false};
};

void reportToPython(const News& news, const py::object& progress) {
  for (const auto& text : news.messages) py::module_::import("logging").attr("getLogger")("squat").attr("info")(text);
  if (!progress.is_none())
    for (const auto& [phase, fraction] : news.reports) progress(phase, fraction);
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

}  // namespace

void computeAside(const py::object& progress, const std::function<void(Monitor&)>& work) {
  Mailbox mailbox;
  std::exception_ptr ofWork, ofPython;
  std::thread computing([&] {
    try {
      work(mailbox);
    } catch (...) {
      ofWork = std::current_exception();
    }
    mailbox.end();
  });
  for (bool isDone = false; !isDone;) {
    News news;
    {
      const py::gil_scoped_release others;
      news = mailbox.await();
    }
    isDone = news.isDone;
    if (ofPython) continue;  // only waits for the computation to notice
    try {
      reportToPython(news, progress);
    } catch (...) {
      ofPython = std::current_exception();
      mailbox.cancel();
    }
  }
  computing.join();
  if (ofPython) std::rethrow_exception(ofPython);
  if (ofWork) std::rethrow_exception(ofWork);
}

void requireThreads(int threads) {
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  const int maximum = std::max(anyMachine, threadsOfACore * cores);
  if (threads < 0 || threads > maximum)
    throw CaseError({{"threads", std::to_string(threads), "0 for all cores, or 1 to " + std::to_string(maximum),
                      "Threads wait for each other at every step: more than there are cores are slow"}});
}

void requireBetween(const char* name, double value, double low, double high, const char* allowed) {
  if (!(value >= low && value <= high)) throw CaseError({{name, text::numberText(value), allowed, ""}});
}

}  // namespace squat::python
