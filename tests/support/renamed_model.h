#pragma once

#include <fstream>
#include <regex>
#include <sstream>
#include <string>

namespace texbrdf::test {

inline std::string read_model(const std::string& name) {
  std::ifstream file(std::string(TEXBRDF_TEST_DATA) + "/models/" + name + ".tex", std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The equations of cook-torrance.tex so many times, the names of each copy with the subscript of its number, so that
/// every copy is a model of its own. Without the preamble.
inline std::string renamed_copies(const std::string& model, int copies) {
  const std::regex name(R"((\\rho_[ds])|(\bm\b)|(\b[fDG]\b))");
  const size_t first = model.find("\\begin{equation}");
  const std::string equations = model.substr(first, model.find("\\end{document}") - first);
  std::string document;
  for (int i = 0; i < copies; ++i) {
    const std::string number = std::to_string(i);
    const auto begin = std::sregex_iterator(equations.begin(), equations.end(), name);
    size_t done = 0;
    for (auto match = begin; match != std::sregex_iterator(); ++match) {
      document.append(equations, done, static_cast<size_t>(match->position()) - done);
      const std::string found = match->str();
      const size_t underscore = found.find('_');
      document += underscore == std::string::npos
                      ? found + "_{" + number + "}"
                      : found.substr(0, underscore) + "_{" + found.substr(underscore + 1) + "," + number + "}";
      done = static_cast<size_t>(match->position() + match->length());
    }
    document.append(equations, done);
  }
  return document;
}

}  // namespace texbrdf::test
