#pragma once

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace texbrdf::test {

/// A whole file of the tests, or an exception with its path.
inline std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace texbrdf::test
