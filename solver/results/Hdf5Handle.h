// solver/results/Hdf5Handle.h - owning ids of the HDF5 C API; only for the .cpp files of this folder and of rcmdx.
#pragma once

#include <hdf5.h>

#include <mutex>
#include <string>
#include <utility>

#include "core/Errors.h"

namespace squat::results::hdf5 {

// Closes the id with the function of its kind.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Handle() { reset(); }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  hid_t get() const { return id_; }
  bool valid() const { return id_ >= 0; }
  bool reset() {  // false where closing failed
    const bool good = id_ < 0 || close_(id_) >= 0;
    id_ = -1;
    return good;
  }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

// Debian's library is not safe for threads: one user at a time. Silences its own printing of errors as well.
std::unique_lock<std::mutex> lockLibrary();

// What the library says about its last failure, in one line.
std::string lastError();

// Throws FileError(path, object) where `result` reports a failure; hands it on otherwise.
template <typename Result>
Result check(Result result, const std::string& path, const std::string& object, const char* what) {
  if (result < 0) {
    const auto reason = lastError();
    throw FileError(path, object, std::string(what) + (reason.empty() ? "" : " (" + reason + ")"));
  }
  return result;
}

}  // namespace squat::results::hdf5
