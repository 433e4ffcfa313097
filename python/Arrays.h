// python/Arrays.h - arrays of NumPy onto memory of the library: read-only, and nothing is copied.
#pragma once

#include <pybind11/numpy.h>

#include <vector>

namespace squat::python {

// An array onto `data`, which stays alive as long as the array does because `owner`, its `base`, holds it. Without
// `strides` [bytes], row by row.
template <typename T>
pybind11::array view(const T* data, std::vector<pybind11::ssize_t> shape, const pybind11::object& owner,
                     std::vector<pybind11::ssize_t> strides = {}) {
  pybind11::array array(pybind11::dtype::of<T>(), std::move(shape), std::move(strides), data, owner);
  array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

template <typename T>
pybind11::array view(const std::vector<T>& values, const pybind11::object& owner) {
  return view(values.data(), {static_cast<pybind11::ssize_t>(values.size())}, owner);
}

// `values` as rows of `width` numbers.
template <typename T>
pybind11::array viewOfRows(const std::vector<T>& values, std::size_t width, const pybind11::object& owner) {
  const std::size_t rows = width == 0 ? 0 : values.size() / width;
  return view(values.data(), {static_cast<pybind11::ssize_t>(rows), static_cast<pybind11::ssize_t>(width)}, owner);
}

// One member of every struct.
template <typename T, typename Struct>
pybind11::array viewOfMember(const std::vector<Struct>& all, T Struct::*member, const pybind11::object& owner) {
  const T* first = all.empty() ? nullptr : &(all.front().*member);
  return view(first, {static_cast<pybind11::ssize_t>(all.size())}, owner,
              {static_cast<pybind11::ssize_t>(sizeof(Struct))});
}

}  // namespace squat::python
