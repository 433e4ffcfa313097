#include "trust/Program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace squat::tests {

namespace {
constexpr auto kPoll = std::chrono::milliseconds(5);
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kSlowdown = 4;  // a sanitizer makes the program as much slower
#else
constexpr int kSlowdown = 1;
#endif
}  // namespace

Program::Program(const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  std::vector<std::string> words{SQUAT_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv, envp;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  auto added = environment;
  for (char** entry = environ; *entry; ++entry) {
    const std::string text = *entry;
    const auto name = text.substr(0, text.find('=') + 1);
    bool replaced = false;
    for (const auto& mine : environment) replaced = replaced || mine.rfind(name, 0) == 0;
    if (!replaced) envp.push_back(*entry);
  }
  for (auto& mine : added) envp.push_back(mine.data());
  envp.push_back(nullptr);
  process_ = ::fork();
  if (process_ == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::dup2(ends[1], STDERR_FILENO);
    ::execve(SQUAT_PROGRAM, argv.data(), envp.data());
    ::_exit(127);
  }
  ::close(ends[1]);
  pipe_ = ends[0];
  ::fcntl(pipe_, F_SETFL, O_NONBLOCK);
}

Program::~Program() {
  if (!ended_) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, &status_, 0);
  }
  ::close(pipe_);
}

void Program::collect() {
  char buffer[4096];
  for (ssize_t got = 0; (got = ::read(pipe_, buffer, sizeof buffer)) > 0;)
    output_.append(buffer, static_cast<std::size_t>(got));
}

bool Program::running() {
  if (!ended_ && ::wait4(process_, &status_, WNOHANG, &used_) == process_) ended_ = true;
  collect();
  return !ended_;
}

bool Program::waitForOutput(const std::string& text, std::chrono::seconds maximumWait) {
  const auto end = std::chrono::steady_clock::now() + kSlowdown * maximumWait;
  while (output_.find(text) == std::string::npos) {
    const bool alive = running();
    if (output_.find(text) != std::string::npos) return true;
    if (!alive || std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(kPoll);
  }
  return true;
}

double Program::processorSeconds() const {
  if (ended_) {
    const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * t.tv_usec; };
    return seconds(used_.ru_utime) + seconds(used_.ru_stime);
  }
  // proc(5): fields 14 and 15 of stat, counted behind the name in brackets, are clock ticks in user and kernel mode.
  std::ifstream file("/proc/" + std::to_string(process_) + "/stat");
  std::string word;
  std::getline(file, word, ')');
  for (int field = 3; field < 14; ++field) file >> word;
  double user = 0, kernel = 0;
  file >> user >> kernel;
  return (user + kernel) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

void Program::signal(int number) const { ::kill(process_, number); }

int Program::wait(std::chrono::seconds maximumWait) {
  const auto end = std::chrono::steady_clock::now() + kSlowdown * maximumWait;
  while (running()) {
    if (std::chrono::steady_clock::now() > end) {
      ::kill(process_, SIGKILL);
      ::waitpid(process_, &status_, 0);
      ended_ = true;
      return -1000;
    }
    std::this_thread::sleep_for(kPoll);
  }
  return WIFSIGNALED(status_) ? -WTERMSIG(status_) : WEXITSTATUS(status_);
}

int call(const std::vector<std::string>& arguments, std::string* output, const std::vector<std::string>& environment) {
  Program program(arguments, environment);
  const int code = program.wait();
  if (output) *output = program.output();
  return code;
}

}  // namespace squat::tests
