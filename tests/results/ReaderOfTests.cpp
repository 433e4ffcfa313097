// A reading program with works that a test can ask for: how it sends, refuses and dies.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "core/Errors.h"
#include "core/platform/Process.h"
#include "results/ReaderProgram.h"

namespace {

using squat::results::ByteSink;
using squat::results::ReaderArguments;

void sendKind(const ByteSink& send) {
  const std::byte kind{'k'};
  send(std::span(&kind, 1));
}

void echo(ReaderArguments& arguments, const ByteSink& send) {
  sendKind(send);
  const auto text = arguments.text();
  send(std::as_bytes(std::span(text)));
}

void refuse(ReaderArguments&, const ByteSink&) { throw squat::FileError("a.h5", "/signals", "is cut off"); }
void crash(ReaderArguments&, const ByteSink&) { std::raise(SIGSEGV); }

void computeForEver(ReaderArguments&, const ByteSink&) {
  for (volatile unsigned turn = 0;;) turn = turn + 1;
}

void takeMemory(ReaderArguments& arguments, const ByteSink& send) {
  const std::vector<std::byte> much(arguments.number(), std::byte{1});
  sendKind(send);
}

// Into a folder, an empty file with the number of this process: with a size it could not be written.
void sayWhoAndSendMuch(ReaderArguments& arguments, const ByteSink& send) {
  std::ofstream(std::filesystem::path(arguments.text()) / std::to_string(squat::platform::processNumber())).flush();
  send(std::vector<std::byte>(1 << 20));
}

void writeFile(ReaderArguments& arguments, const ByteSink& send) {
  std::ofstream(arguments.text()) << "more than nothing";
  sendKind(send);
}

}  // namespace

int main() {
  return squat::results::answerCaller({{"echo", echo},
                                       {"refuse", refuse},
                                       {"crash", crash},
                                       {"compute for ever", computeForEver},
                                       {"take memory", takeMemory},
                                       {"say who and send much", sayWhoAndSendMuch},
                                       {"write a file", writeFile}});
}
