// The program `squat` as a child process: started, watched, signalled, waited for.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

namespace squat::tests {

class Program {
 public:
  // Starts squat with these arguments and "NAME=value" added to its environment; both outputs are collected.
  explicit Program(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  // True as soon as the output holds `text`; false when the program ended or the time is up before that.
  bool waitForOutput(const std::string& text, std::chrono::seconds maximumWait = std::chrono::seconds(120));
  void signal(int number) const;
  // Exit code; minus the signal where one ended it; -1000 where it had to be ended because the time was up.
  int wait(std::chrono::seconds maximumWait = std::chrono::seconds(300));
  const std::string& output() const { return output_; }
  pid_t process() const { return process_; }
  double processorSeconds() const;  // used so far, also after the end
  bool running();

 private:
  void collect();
  pid_t process_ = -1;
  int pipe_ = -1;
  int status_ = 0;
  bool ended_ = false;
  rusage used_{};  // in all, once it has ended
  std::string output_;
};

// Runs to the end; exit code as Program::wait().
int call(const std::vector<std::string>& arguments, std::string* output = nullptr,
         const std::vector<std::string>& environment = {});

}  // namespace squat::tests
