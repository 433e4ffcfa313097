// What only one system or one compiler has stands in solver/core/platform, so that another one needs nothing but that
// folder. Excepted are the kernels, which are written for the vectors of one compiler.
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "arch/SourceTree.h"

namespace squat::arch {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

bool isPlatform(const std::string& path) { return path.starts_with("solver/core/platform/"); }

bool isKernel(const std::string& path) {
  return path.starts_with("solver/elasticity/Swept") || path.starts_with("solver/plasticity/LayerKernel");
}

// Also those of C itself: they hand on what the system adds to them; <ctime> and its like stand for them.
bool isHeaderOfOneSystem(const std::string& name) {
  static const std::set<std::string> headers{
      "alloca.h", "cpuid.h",     "cxxabi.h", "direct.h",   "dirent.h", "dlfcn.h",   "errno.h",   "execinfo.h",
      "fcntl.h",  "fnmatch.h",   "ftw.h",    "getopt.h",   "glob.h",   "grp.h",     "io.h",      "langinfo.h",
      "libgen.h", "limits.h",    "malloc.h", "netdb.h",    "poll.h",   "process.h", "pthread.h", "pwd.h",
      "sched.h",  "semaphore.h", "signal.h", "spawn.h",    "stdio.h",  "stdlib.h",  "string.h",  "strings.h",
      "syslog.h", "termios.h",   "time.h",   "ucontext.h", "unistd.h", "utime.h",   "windows.h", "wordexp.h",
      "math.h",   "stdint.h",    "ctype.h",  "locale.h",   "endian.h", "err.h",     "link.h",    "features.h"};
  static const std::vector<std::string> folders{"arpa/", "asm/", "bits/", "ext/", "linux/", "netinet/", "sys/"};
  if (name.ends_with("intrin.h") || name == "arm_neon.h") return true;
  return headers.count(name) > 0 || std::any_of(folders.begin(), folders.end(),
                                                [&](const std::string& folder) { return name.starts_with(folder); });
}

// Functions, types and constants that no code of ours would call by the same name.
bool isNameOfOneSystem(const std::string& name) {
  static const std::set<std::string> names{
      "clock_gettime", "dladdr",        "dlopen",       "dlsym",        "environ",
      "execl",         "execlp",        "execv",        "execve",       "execvp",
      "fcntl",         "fdatasync",     "fdopen",       "fileno",       "flock",
      "fork",          "fseeko",        "fstat",        "fsync",        "ftello",
      "ftruncate",     "gethostname",   "getpid",       "getppid",      "getpriority",
      "getpwuid",      "getrlimit",     "getrusage",    "gettimeofday", "getuid",
      "gmtime_r",      "id_t",          "ioctl",        "isatty",       "killpg",
      "localtime_r",   "lstat",         "madvise",      "mallinfo",     "mallinfo2",
      "malloc_trim",   "mallopt",       "mkdtemp",      "mkfifo",       "mkstemp",
      "mmap",          "mode_t",        "munmap",       "nanosleep",    "off_t",
      "openat",        "opendir",       "pclose",       "pid_t",        "pipe2",
      "popen",         "pread",         "putenv",       "pwrite",       "readdir",
      "readlink",      "realpath",      "rlimit",       "rusage",       "sched_getaffinity",
      "sched_yield",   "setenv",        "setpriority",  "setrlimit",    "sigaction",
      "sigaddset",     "sigemptyset",   "sigprocmask",  "sigset_t",     "sigtimedwait",
      "ssize_t",       "statvfs",       "strcasecmp",   "strdup",       "strerror_r",
      "strsignal",     "strtok_r",      "syscall",      "sysconf",      "timegm",
      "unlink",        "unsetenv",      "usleep",       "utimensat",    "vfork",
      "waitpid",       "_exit",         "SIGINT",       "SIGKILL",      "SIGPIPE",
      "SIGTERM",       "SIGSEGV",       "SIGHUP",       "SIGUSR1",      "SIGXCPU",
      "SIGXFSZ",       "STDERR_FILENO", "STDIN_FILENO", "STDOUT_FILENO"};
  return names.count(name) > 0 || name.starts_with("O_") || name.starts_with("pthread_") ||
         name.starts_with("posix_") || name.starts_with("RLIMIT_") || name.starts_with("M_PI") ||
         name.starts_with("S_IS");
}

// Two underscores begin what belongs to a compiler; these are every compiler's.
bool isNameOfOneCompiler(const std::string& name) {
  static const std::set<std::string> standard{"__cplusplus", "__FILE__",      "__LINE__",
                                              "__func__",    "__has_include", "__VA_ARGS__"};
  return name == "asm" || name == "_WIN32" || name == "_MSC_VER" ||
         (name.starts_with("__") && standard.count(name) == 0);
}

bool isOfAName(char sign) { return std::isalnum(static_cast<unsigned char>(sign)) != 0 || sign == '_'; }

struct Name {
  std::string text;
  bool isGlobal = false;  // "::name": the system's, or a library's in C
  bool isCalled = false;  // "name("
};

// Those of code but for members ("a.name", "a->name") and what belongs to a namespace or a class ("a::name").
std::vector<Name> namesIn(const std::string& code) {
  std::vector<Name> names;
  for (std::size_t end = 0, begin = 0; begin < code.size(); begin = end + 1) {
    end = begin;
    while (end < code.size() && isOfAName(code[end])) ++end;
    if (end == begin || std::isdigit(static_cast<unsigned char>(code[begin])) != 0) continue;
    const std::string before = "   " + code.substr(begin < 3 ? 0 : begin - 3, std::min<std::size_t>(begin, 3));
    if (before.ends_with('.') || before.ends_with("->")) continue;
    const bool isQualified = before.ends_with("::");
    const char owner = before[before.size() - 3];
    if (isQualified && (isOfAName(owner) || owner == '>')) continue;
    names.push_back({code.substr(begin, end - begin), isQualified, end < code.size() && code[end] == '('});
  }
  return names;
}

bool isCallOfTheSystem(const Name& name) {
  static const std::set<std::string> ofLibraries{"crc32_z"};  // zlib's
  return name.isGlobal && name.isCalled && ofLibraries.count(name.text) == 0;
}

// What a file has of one system or compiler.
std::set<std::string> ofOnePlatform(const SourceFile& file) {
  std::set<std::string> found;
  for (const auto& include : file.includes)
    if (!include.quoted && isHeaderOfOneSystem(include.name)) found.insert("<" + include.name + ">");
  for (const auto& name : namesIn(file.code))
    if (isNameOfOneSystem(name.text) || isCallOfTheSystem(name) ||
        (isNameOfOneCompiler(name.text) && !isKernel(file.path)))
      found.insert(name.text);
  for (const char* words : {"[[gnu::", "#pragma GCC", "#pragma clang", "#pragma omp"})
    if (!isKernel(file.path) && file.code.find(words) != std::string::npos) found.insert(words);
  for (const char* path : {"\"/proc/", "\"/sys/", "\"/dev/"})
    if (file.text.find(path) != std::string::npos) found.insert(path);
  return found;
}

TEST(Platform, WhatOneSystemOrCompilerHasStandsInItsFolder) {
  std::vector<std::string> list;
  for (const auto& file : readSources(SQUAT_SOURCE_DIR, {"solver", "widgets", "app", "python"}))
    if (!isPlatform(file.path))
      for (const auto& what : ofOnePlatform(file))
        list.push_back(file.path + " has " + what + "; ask solver/core/platform, or put it there");
  EXPECT_THAT(list, IsEmpty());
}

// Another system has the same headers, with sources of its own.
TEST(Platform, ItsHeadersShowNothingOfOneSystem) {
  std::vector<std::string> list;
  int headers = 0;
  for (const auto& file : readSources(SQUAT_SOURCE_DIR, {"solver"})) {
    if (!isPlatform(file.path) || !file.path.ends_with(".h")) continue;
    ++headers;
    for (const auto& include : file.includes)
      if (isHeaderOfOneSystem(include.name)) list.push_back(file.path + " includes " + include.name);
    for (const auto& name : namesIn(file.code))
      if (isNameOfOneSystem(name.text)) list.push_back(file.path + " has " + name.text);
  }
  EXPECT_THAT(list, IsEmpty());
  EXPECT_GT(headers, 10);
}

std::set<std::string> foundIn(const std::string& text, const std::string& path = "solver/model/A.cpp") {
  SourceFile file;
  file.path = path;
  file.text = text;
  file.code = withoutComments(text);
  return ofOnePlatform(file);
}

TEST(Platform, IsFoundInCalls) {
  EXPECT_THAT(foundIn("if (::close(file) == 0) ::fsync(file);"), ElementsAre("close", "fsync"));
  EXPECT_THAT(foundIn("long a=getpid();\npid_t child;\nraise(SIGINT)"), ElementsAre("SIGINT", "getpid", "pid_t"));
  EXPECT_THAT(foundIn("isatty(2)"), ElementsAre("isatty"));
  EXPECT_THAT(foundIn("stream.open(a); file->fsync(); std::remove(a); a::unlink(b); std::set<int>::fork(c);"),
              IsEmpty());
  EXPECT_THAT(foundIn("read(a); link(b); // fork()\n f(\"getpid()\"); ::testing::Test(a); 0x_exit"), IsEmpty());
}

TEST(Platform, IsFoundInWordsOfCompilersAndInPaths) {
  EXPECT_THAT(foundIn("#if defined(__linux__)\n#endif\n"), ElementsAre("__linux__"));
  EXPECT_THAT(foundIn("[[gnu::noinline]] void f();"), ElementsAre("[[gnu::"));
  EXPECT_THAT(foundIn("#if __cplusplus > 201703L\n"), IsEmpty());
  EXPECT_THAT(foundIn("__builtin_prefetch(p);", "solver/elasticity/SweptTie.cpp"), IsEmpty());
  EXPECT_THAT(foundIn("fork();", "solver/elasticity/SweptTie.cpp"), ElementsAre("fork"));
  EXPECT_THAT(foundIn("std::ifstream file(\"/proc/meminfo\");"), ElementsAre("\"/proc/"));
}

TEST(Platform, IsFoundInHeaders) {
  for (const char* header : {"unistd.h", "sys/stat.h", "fcntl.h", "signal.h", "time.h", "linux/limits.h"})
    EXPECT_TRUE(isHeaderOfOneSystem(header)) << header;
  for (const char* header : {"csignal", "ctime", "hdf5.h", "zlib.h", "nlohmann/json.hpp", "pybind11/stl.h"})
    EXPECT_FALSE(isHeaderOfOneSystem(header)) << header;
}

}  // namespace
}  // namespace squat::arch
