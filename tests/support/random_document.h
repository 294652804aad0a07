#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "support/random.h"

namespace texbrdf::test {

struct RandomDocumentOptions {
  int parameters = 3;   ///< definitions whose right side is a literal
  int functions = 3;    ///< functions of one to three parameters
  int definitions = 5;  ///< plain ones, the root not counted
  int depth = 4;        ///< of an expression
};

/// A document without errors that uses all of the language. Every expression stays finite and well conditioned where
/// the directions are unit vectors above the horizon, so that two right evaluations of it agree up to rounding.
class RandomDocument {
 public:
  RandomDocument(uint64_t seed, const RandomDocumentOptions& options) : random_(seed), options_(options) {
    random_.shuffle(names_);
  }

  std::string make() {
    for (int i = 0; i < options_.parameters; ++i) add_parameter();
    add_function_of_components();
    for (int i = 0; i < options_.functions; ++i) add_function();
    for (int i = 0; i < options_.definitions; ++i) add_definition();
    add_root();
    random_.shuffle(equations_);
    std::string text = "Prose before the equations, with $a$ formula in it.\n\n";
    for (size_t i = 0; i < equations_.size();) i += append_region(text, i);
    return text;
  }

 private:
  struct Equation {
    std::string left, right, comment;
  };

  enum class Kind : uint8_t { Real, Vector, Colour };

  struct Function {
    std::string name;
    std::vector<bool> vector_parameters;
    Kind result;
  };

  /// The names that an expression may use. Reals lie in [-1, 1], components of vectors and colours too.
  struct Scope {
    std::vector<std::string> reals;
    std::vector<std::string> vectors;
    std::vector<std::string> colours;
    std::vector<std::string> tuples;  ///< of numbers: vectors and colours
    std::vector<std::string> angles{"\\theta_i", "\\theta_o", "\\theta_h", "\\theta_d", "\\phi_i", "\\phi_{o}"};
  };

  std::string next_name() {
    if (!names_.empty()) {
      const std::string name = names_.back();
      names_.pop_back();
      return name;
    }
    return "w_{" + std::to_string(++numbered_names_) + "}";
  }

  void add_block(const std::string& left, const std::string& right, const std::string& comment = "") {
    equations_.push_back({left, right, comment.empty() ? "" : " % " + comment});
  }

  /// Writes the equation, perhaps with some that follow it, as papers do; gives how many.
  size_t append_region(std::string& text, size_t first) {
    const auto whole = [&](const std::string& begin, const std::string& end) {
      const Equation& e = equations_[first];
      text += begin + e.comment + "\n  " + e.left + " = " + e.right + "\n" + end + "\n\n";
      return size_t{1};
    };
    switch (random_.below(8)) {
      case 0:
        return whole("\\begin{equation*}", "\\end{equation*}");
      case 1:
        return whole("\\[", "\\]");
      case 2:
        return whole("$$", ".$$");
      case 3:
        return whole("Inline, $", "$ is a definition.");
      case 4:
        return append_rows(text, first);
      default:
        return whole("\\begin{equation}", "\\end{equation}");
    }
  }

  size_t append_rows(std::string& text, size_t first) {
    const size_t count = std::min<size_t>(1 + random_.below(4), equations_.size() - first);
    text += "\\begin{align}\n";
    for (size_t i = first; i < first + count; ++i) {
      const Equation& e = equations_[i];
      text += "  " + e.left + " &= " + e.right + (random_.chance(0.5) ? " \\\\" : ", \\\\") + e.comment + "\n";
    }
    text += "\\end{align}\n\n";
    return count;
  }

  std::string number(double low, double high) {
    const int thousandths = random_.between(static_cast<int>(low * 1000), static_cast<int>(high * 1000));
    std::string digits = std::to_string(thousandths % 1000 + 1000);
    digits[0] = '.';
    return std::to_string(thousandths / 1000) + digits;
  }

  void add_parameter() {
    const std::string name = next_name();
    if (random_.chance(0.3)) {
      const std::string components = number(0, 1) + ", " + number(0, 1) + ", 0.5";
      const bool is_tuple = !is_vector_name(name) && random_.chance(0.5);
      add_block(name, is_tuple ? "(" + components + ")" : "\\vec{" + components + "}");
      (is_tuple ? document_.tuples : document_.vectors).push_back(name);
      return;
    }
    const bool constant = random_.chance(0.2);
    add_block(name, number(0.1, 1), constant ? "constant" : random_.chance(0.3) ? "range [0.05, 1]" : "");
    document_.reals.push_back(name);
  }

  static bool is_vector_name(const std::string& name) { return name.starts_with("\\vec"); }

  Kind random_kind() {
    if (random_.chance(0.6)) return Kind::Real;
    return random_.chance(0.5) ? Kind::Vector : Kind::Colour;
  }

  std::string expression_of(Kind kind, const Scope& scope) {
    if (kind == Kind::Colour) return colour(scope, options_.depth);
    return kind == Kind::Vector ? vector_of(scope) : real_of(scope);
  }

  void add_function() {
    static const std::vector<std::string> real_names{"x", "y_1", "\\tau", "\\theta_h", "\\beta"};
    static const std::vector<std::string> vector_names{"\\vec{u}", "\\omega_i", "\\vec{h}", "\\vec{v_2}",
                                                       "\\vec{\\omega_o}"};
    Function function{.name = next_name(), .vector_parameters = {}, .result = random_kind()};
    if (is_vector_name(function.name)) function.result = Kind::Vector;
    Scope scope = document_;
    std::string left = function.name + "(";
    std::vector<std::string> parameters;
    const int count = random_.between(1, 3);
    for (int i = 0; i < count; ++i) {
      const bool vector = random_.chance(0.5);
      const std::string& name =
          (vector ? vector_names : real_names)[(random_.below(3) + 2 * static_cast<size_t>(i)) % 5];
      if (std::find(parameters.begin(), parameters.end(), name) != parameters.end()) continue;
      parameters.push_back(name);
      left += (function.vector_parameters.empty() ? "" : ", ") + name;
      function.vector_parameters.push_back(vector);
      hide(scope, name);
      // Twice, so that bodies use what they are given.
      for (int repeat = 0; repeat < 2; ++repeat) (vector ? scope.vectors : scope.reals).push_back(name);
    }
    add_block(left + ")", expression_of(function.result, scope));
    functions_.push_back(function);
  }

  /// A function of reals that takes colours too.
  void add_function_of_components() {
    static const std::vector<std::string> bodies{"0.3 * (x * y + (1 - x) y^2)",
                                                 "\\frac{x}{2 + y} * 0.5 + 0.2 * \\exp(-y)",
                                                 "\\max(x, y, 0.2) \\sqrt{2 + x} / 2"};
    const std::string name = next_name();
    if (is_vector_name(name)) return;
    add_block(name + "(x, y)", random_.one_of(bodies));
    of_components_.push_back(name);
  }

  static void hide(Scope& scope, const std::string& name) {
    const auto erase = [&name](std::vector<std::string>& names) {
      names.erase(std::remove(names.begin(), names.end(), name), names.end());
    };
    erase(scope.reals);
    erase(scope.vectors);
    erase(scope.colours);
    erase(scope.tuples);
    erase(scope.angles);
  }

  void add_definition() {
    const std::string name = next_name();
    const Kind kind = is_vector_name(name) ? Kind::Vector : random_kind();
    add_block(name, expression_of(kind, document_));
    if (kind == Kind::Real) document_.reals.push_back(name);
    if (kind == Kind::Vector) document_.vectors.push_back(name);
    if (kind == Kind::Colour) document_.colours.push_back(name);
  }

  void add_root() {
    const std::string integrated = random_.chance(0.2) ? " + " + integral(document_) : "";
    const std::string real = "2 + " + real_of(document_) + " + " + real_of(document_) + integrated;
    const std::string vector = vector_of(document_);
    switch (random_.below(5)) {
      case 0:
        return add_block("f", real);
      case 2:
        return add_block("f", real + " + " + colour(document_, options_.depth));
      case 3:
        return add_block("f", group(real) + " " + group(colour(document_, options_.depth)));
      case 1:
        return add_block("f", "\\left(" + real + "\\right) * " + vector);
      default:
        Scope scope = document_;
        hide(scope, "\\omega_i");
        scope.vectors.push_back("\\vec{a}");
        return add_block("f(\\vec{a}, \\omega_o)", vector + " + " + real_of(scope) + " * \\vec{a}");
    }
  }

  /// An expression whose range is within [-1, 1], as one operand.
  std::string real_of(const Scope& scope) { return real(scope, options_.depth); }
  std::string vector_of(const Scope& scope) { return vector(scope, options_.depth); }

  std::string group(const std::string& text) {
    switch (random_.below(3)) {
      case 0:
        return "(" + text + ")";
      case 1:
        return "{" + text + "}";
      default:
        return "\\left( " + text + " \\right)";
    }
  }

  std::string real_leaf(const Scope& scope) {
    if (random_.chance(0.2) || scope.reals.empty()) return number(0, 1);
    if (random_.chance(0.1)) return "\\epsilon";
    return random_.one_of(scope.reals);
  }

  std::string angle(const Scope& scope) {
    if (scope.angles.empty() || random_.chance(0.1)) return " " + real_leaf(scope);
    const std::string one = random_.one_of(scope.angles);
    switch (random_.below(4)) {
      case 0:
        return "{" + one + " - " + random_.one_of(scope.angles) + "}";
      case 1:
        return "(2*" + one + " + " + random_.one_of(scope.angles) + ")";
      default:
        return " " + one;
    }
  }

  std::string positive(const Scope& scope, int depth) { return group("2 + " + real(scope, depth)); }

  std::string real(const Scope& scope, int depth) {
    if (depth == 0 || random_.chance(0.1)) return real_leaf(scope);
    const int next = depth - 1;
    switch (random_.below(26)) {
      case 25:
        return sum(scope, next);
      case 0:
        return group(real(scope, next) + " * 0.5 + " + real(scope, next) + "/2");
      case 1:
        return group("0.5 \\cdot " + real(scope, next) + " - \\frac{" + real(scope, next) + "}{2}");
      case 2:
        return group(real(scope, next) + " * " + real(scope, next));
      case 3:
        return "\\frac{" + real(scope, next) + "}{" + positive(scope, next) + "}";
      case 4:
        return group(real(scope, next) + " / " + positive(scope, next));
      case 5:
        return group("-" + real(scope, next));
      case 6:
        return "\\sin" + angle(scope);
      case 7:
        return "\\cos" + angle(scope);
      case 8:
        return group("\\cos{" + angle(scope) + "}^" + std::to_string(random_.between(2, 9)));
      case 9:
        return group("\\exp{-\\tan{\\theta_i}^2}");
      case 10:
        return "\\max(" + real(scope, next) + ", " + real(scope, next) + ", " + real_leaf(scope) + ")";
      case 11:
        return "\\min{" + real(scope, next) + ", " + real(scope, next) + "}";
      case 12:
        return group(positive(scope, next) + "^{-" + std::to_string(random_.between(1, 4)) + "}");
      case 13:
        return group("0.3 * \\sqrt[" + std::to_string(random_.between(2, 3)) + "]{" + positive(scope, next) + "}");
      case 14:
        return group("\\sqrt{" + positive(scope, next) + "}^{" + real(scope, next) + "} / 1.8");
      case 15:
        return group(random_.one_of(elementary_) + group("0.7 * " + real(scope, next)) + " * 0.4");
      case 16:
        return group("\\ln" + positive(scope, next) + " / 1.2");
      case 17:
        return group("(" + vector(scope, next) + ") " + (random_.chance(0.5) ? "\\cdot" : "*") + " (" +
                     vector(scope, next) + ") / 3");
      case 18:
        return group(real(scope, next) + " * \\pi / 4");
      case 19:
        return group(group(real(scope, next)) + group(real(scope, next)));
      case 20:
        return group("\\cos^{" + std::to_string(random_.between(2, 9)) + "}" + angle(scope));
      case 22:
        return group(group(real(scope, next)) + (random_.chance(0.5) ? "^+" : "^{+}"));
      case 23:
        return absolute_value(real(scope, next / 2));
      case 21:
        if (scope.reals.empty()) return real_leaf(scope);
        return group(random_.one_of(scope.reals) + "(" + real(scope, next) + ")");
      default:
        return call(scope, next, Kind::Real);
    }
  }

  /// Its index is in [-1, 1] too where it is divided.
  std::string sum(const Scope& scope, int depth) {
    Scope inner = scope;
    hide(inner, "q");
    inner.reals.push_back("(q/3)");
    const std::string body = real(inner, depth);
    if (random_.chance(0.3)) return group("\\sum_{q \\in \\{1, -2\\}} " + body + " / 2");
    return group("\\sum_{q=1}^{3} " + body + " / 3");
  }

  /// Each is two loops, of which a program has only so many.
  std::string integral(const Scope& scope) {
    Scope inner = scope;
    inner.reals.push_back("q");
    return group("\\int_0^1 " + real(inner, 1) + "\\,dq");
  }

  /// As cases, so that it does not matter which of two values that are nearly equal decides.
  std::string absolute_value(const std::string& x) {
    switch (random_.below(3)) {
      case 0:
        return "\\begin{cases} " + x + " & \\text{if } " + x + " > 0 \\\\ -" + x + " & \\text{otherwise} \\end{cases}";
      case 1:
        return "\\left\\{\\begin{array}{ll} -" + x + ", & -2 \\le " + x + " < 0 \\\\ " + x + "\\end{array}\\right.";
      default:
        return "\\begin{cases} " + x + " & \\neg(" + x + " \\le 0) \\land 2 > 1 \\\\ -" + x + " & " + x +
               " \\in [-2, 0] \\lor 1 = 2 \\end{cases}";
    }
  }

  std::string tuple(const Scope& scope, int depth) {
    if (!scope.tuples.empty() && random_.chance(0.4)) return random_.one_of(scope.tuples);
    const int next = depth == 0 ? 0 : depth - 1;
    return "(" + real(scope, next) + ", " + real(scope, next) + ", " + number(0, 1) + ")";
  }

  /// A colour, or a tuple that can be one.
  std::string colour(const Scope& scope, int depth) {
    if (depth == 0 || random_.chance(0.1)) {
      return scope.colours.empty() || random_.chance(0.4) ? tuple(scope, 0) : random_.one_of(scope.colours);
    }
    const int next = depth - 1;
    const auto inner = [&] { return colour(scope, next); };
    const auto positive_colour = [&] { return group("2 + " + inner()); };
    switch (random_.below(19)) {
      case 0:
        return tuple(scope, next);
      case 17:
        return "\\begin{cases} " + inner() + " & " + real(scope, next) + " < 2 \\\\ " + real(scope, next) +
               " \\end{cases}";
      case 15:
      case 16:
        if (of_components_.empty()) return tuple(scope, next);
        return random_.one_of(of_components_) + "(" + inner() + ", " +
               (random_.chance(0.5) ? inner() : real(scope, next)) + ")";
      case 1:
        return group(inner() + (random_.chance(0.5) ? " * " : " \\cdot ") + inner());
      case 2:
        return group(group(inner()) + group(inner()));
      case 3:
        return group(real(scope, next) + "/2 + 0.5 * " + inner());
      case 4:
        return group(inner() + " / 2 - 0.5 * " + real(scope, next));
      case 5:
        return group("0.5 * " + inner() + " - " + inner() + " / 2");
      case 6:
        return "\\frac{" + inner() + "}{" + positive_colour() + "}";
      case 7:
        return group(real(scope, next) + " / " + positive_colour());
      case 8:
        return group("\\sqrt{" + positive_colour() + "}^{" + real(scope, next) + "} / 1.8");
      case 9:
        return group(group(inner()) + "^" + std::to_string(random_.between(2, 9)));
      case 10:
        return group(positive(scope, next) + "^{" + inner() + "} / 3");
      case 11:
        return group(random_.one_of(elementary_) + group("0.7 * " + inner()) + " * 0.4");
      case 12:
        return group("\\ln" + positive_colour() + " / 1.2 - \\exp(-2 + " + inner() + ") * 0.1");
      case 13:
        return "\\max(" + inner() + ", " + real(scope, next) + ", " + inner() + ")";
      case 14:
        return "\\min{" + real(scope, next) + ", -" + inner() + "}";
      default:
        return call(scope, next, Kind::Colour);
    }
  }

  std::string vector(const Scope& scope, int depth) {
    static const std::vector<std::string> inputs{"\\omega_i",  "\\vec{\\omega_o}",  "\\vec{n}", "\\vec{h}",
                                                 "\\mathbf l", "\\hat{\\mathbf n}", "{\\bf v}"};
    if (depth == 0 || random_.chance(0.1)) {
      if (scope.vectors.empty() || random_.chance(0.4)) return random_.one_of(inputs);
      return random_.one_of(scope.vectors);
    }
    const int next = depth - 1;
    switch (random_.below(9)) {
      case 7:
        return group("0.5 * " + vector(scope, next) + " + " + tuple(scope, next) + " / 2");
      case 0:
        return group(vector(scope, next) + " * 0.5 + " + vector(scope, next) + " / 2");
      case 1:
        return group("0.5 * " + vector(scope, next) + " - " + vector(scope, next) + " * 0.5");
      case 2:
        return group(real(scope, next) + " * " + vector(scope, next));
      case 3:
        return group(vector(scope, next) + " / " + positive(scope, next));
      case 4:
        return group(vector(scope, next) + " \\times " + vector(scope, next) + " / 2");
      case 5:
        return "\\vec{" + number(0, 1) + ", -" + number(0, 1) + ", +.5}";
      case 6:
        return group("-" + vector(scope, next));
      default:
        return call(scope, next, Kind::Vector);
    }
  }

  /// Arguments are within the range that bodies are written for, and so are results.
  std::string call(const Scope& scope, int depth, Kind result) {
    std::vector<Function> fitting;
    for (const Function& function : functions_) {
      if (function.result == result) fitting.push_back(function);
    }
    if (fitting.empty() && result == Kind::Colour) return tuple(scope, depth);
    if (fitting.empty()) return result == Kind::Vector ? std::string("\\vec{n}") : real_leaf(scope);
    const Function& function = random_.one_of(fitting);
    std::string text = function.name + "(";
    for (std::size_t i = 0; i < function.vector_parameters.size(); ++i) {
      if (i > 0) text += ", ";
      text += function.vector_parameters[i] ? vector(scope, depth / 2) : real(scope, depth / 2);
    }
    return text + ")";
  }

  Random random_;
  RandomDocumentOptions options_;
  std::vector<std::string> names_{"a",           "val",       "\\rho_d",
                                  "\\rho_s",     "\\alpha_x", "\\text{cook\\_torrance}",
                                  "D",           "G",         "x_1",
                                  "f_{n_i}",     "uH",        "\\phi_{\\text{diff}}",
                                  "s_\\alpha",   "\\vec{t}",  "\\mathrm{spec}",
                                  "n",           "h",         "\\sigma",
                                  "x_{n+1}",     "\\kappa",   "Beckmann",
                                  "\\text{abs}", "F_0",       "\\vec{C_s}"};
  static inline const std::vector<std::string> elementary_{"\\sin",    "\\cos",  "\\tan",  "\\arcsin", "\\arccos",
                                                           "\\arctan", "\\sinh", "\\cosh", "\\tanh"};
  int numbered_names_ = 0;
  Scope document_;
  std::vector<Function> functions_;
  std::vector<Equation> equations_;
  std::vector<std::string> of_components_;  ///< functions of two reals or colours
};

inline std::string random_document(uint64_t seed, const RandomDocumentOptions& options = {}) {
  return RandomDocument(seed, options).make();
}

}  // namespace texbrdf::test
