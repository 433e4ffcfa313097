#include "results/Hdf5Handle.h"

namespace squat::results::hdf5 {

std::unique_lock<std::mutex> lockLibrary() {
  static std::mutex mutex;
  std::unique_lock<std::mutex> lock(mutex);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLset_loading_state(0);  // a file must not make the library load filters from the file system
  return lock;
}

std::string lastError() {
  std::string text;
  const auto innermost = [](unsigned, const H5E_error2_t* error, void* data) -> herr_t {
    try {
      *static_cast<std::string*>(data) = error->desc ? error->desc : "";
    } catch (...) {
    }
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, innermost, &text);
  H5Eclear2(H5E_DEFAULT);
  return text;
}

}  // namespace squat::results::hdf5
