#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/document.h"
#include "emit/emit.h"
#include "features/diagnostics.h"
#include "features/document_symbols.h"
#include "features/hover.h"
#include "features/semantic_tokens.h"

namespace texbrdf {
namespace {

using Random = std::mt19937;

void append(std::string& out, Span span) {
  out += '[' + std::to_string(span.begin) + ',' + std::to_string(span.end) + ')';
}

void append_symbols(std::string& out, const std::vector<features::Symbol>& symbols) {
  for (const features::Symbol& symbol : symbols) {
    out.append(symbol.name).append(": ").append(symbol.type);
    append(out, symbol.whole);
    append(out, symbol.selection);
    append_symbols(out, symbol.children);
  }
  out += '\n';
}

void append_diagnostics(std::string& out, const Snapshot& snapshot) {
  for (const Diagnostic& diagnostic : snapshot.diagnostics()) {
    append(out, snapshot.absolute(diagnostic.where));
    out.append(severity_name(diagnostic.severity)).append(" ").append(message(diagnostic));
    for (const RelatedPlace& place : diagnostic.related) {
      append(out, snapshot.absolute(place.where));
      out += place.message;
    }
    for (const Fix& fix : diagnostic.fixes) {
      out += " fix " + fix.title;
      for (const Edit& edit : fix.edits) {
        append(out, snapshot.absolute(edit.where));
        out += edit.replacement;
      }
    }
    out += '\n';
  }
}

/// All that a user can see of a document.
std::string everything_of(const Snapshot& snapshot) {
  std::string out = snapshot.root_name() + (snapshot.is_ours() ? " ours\n" : " foreign\n");
  append_diagnostics(out, snapshot);
  append_symbols(out, features::document_symbols(snapshot));
  for (const Definition& definition : snapshot.definitions()) {
    out += signature_text(definition.checked->signature) + (definition.in_force ? "" : " hidden") +
           (definition.is_used ? " used" : "") + (definition.checked->sound ? "" : " unsound");
  }
  for (const features::SemanticToken& token : features::semantic_tokens(snapshot, {0, snapshot.text().size()})) {
    append(out, token.span);
    out += std::to_string(static_cast<int>(token.type)) + '/' + std::to_string(token.modifiers);
  }
  for (uint32_t offset = 0; offset < snapshot.text().size(); offset += 7) {
    if (const auto hover = features::hover(snapshot, offset, features::Markup::PlainText)) out += hover->text;
  }
  const Result<ir::Program> program = snapshot.program();
  if (!program) return out + program.error();
  const emit::Target* glsl = emit::find_target("glsl");
  const auto code = glsl->emit(*program, {});
  return out + (code ? code->text : code.error());
}

std::string block(const std::string& equation) {
  return "\\begin{equation}\n  " + equation + "\n\\end{equation}\n";
}

/// A valid document of sixty blocks with chains, functions, colours and conventions.
std::string sound_document(Random& random) {
  std::string text =
      "\\documentclass{article}\n\\newcommand{\\scale}{0.5}\n\\newcommand{\\scaled}[2][m]{(#2 * \\scale + #1)}\n"
      "\\begin{document}\nProse with $x$ and 5\\%.\n";
  text += block("\\rho_d = \\vec{0.5, 0.25, 0.125} % range [0, 1]") + block("m = 0.3");
  text += block("k(\\hat u) = \\theta_u(1 - \\theta_u) + n \\cdot \\mathbf{u}");
  text += block("s = \\sum_{k=50}^{53} a_k k(\\hat n) + \\sum_{i=1}^{m} g'(a_i) + \\int_0^m g(x)\\,dx");
  text += block("g(x) = \\frac{x}{x + 1}") + block("h(\\vec{u}, x) = \\vec{u} \\cdot \\vec{n} * g(x)");
  text += block("D(\\vec{h}, m) = m \\vec{h} \\cdot n + h_x") + block("w = 0.5") +
          block("\\vec{u} = \\omega_i \\times \\omega_o") + block("z = wm + D + \\theta_u");
  text += block("P(x, y) = x \\cdot y") + block("E(a, b, t) = a(1 - t) + b t") +
          block("U(x, y) = P(x, E(x, y, m)) + g(P(y, x))") + block("W(x) = E(x, \\omega_o, m)");
  text += block("q(\\cos\\theta, y) = \\theta + \\cos\\theta") + block("r(u - m) = (u - m)^2");
  for (int i = 0; i < 55; ++i) {
    const std::string name = "a_{" + std::to_string(i) + "}";
    const std::string earlier = i == 0 ? "m" : "a_{" + std::to_string(random() % static_cast<unsigned>(i)) + "}";
    const std::string bodies[] = {"g(" + earlier + ") + \\theta_h",
                                  earlier + " * 0.5 + m",
                                  "\\max(" + earlier + ", 0.25)",
                                  "\\scaled{" + earlier + "}",
                                  "\\scaled[\\theta_i]{" + earlier + "}",
                                  "h(\\vec{\\omega_i}, " + earlier + ") * \\cos{\\theta_o}",
                                  "z" + earlier + " + wzm^2 D",
                                  "P(" + earlier + ", 0.5) + P(\\omega_i, \\vec{n}) + U(\\vec{n}, \\omega_o)",
                                  "U(" + earlier + ", m) * |W(\\omega_i)|",
                                  "|E(\\vec{n}, \\omega_i, " + earlier + ")| + P(\\vec{n}, m) \\cdot \\vec{n}"};
    text += "Term number " + std::to_string(i) + ".\n" + block(name + " = " + bodies[random() % std::size(bodies)]);
  }
  return text +
         block(
             "f = \\rho_d * a_{54} + \\vec{1, 1, 1} * a_{53} * k(\\mathbf l) * q(0.5, z) * r(2) * g^2(m) * |W(\\hat n)|") +
         "\\end{document}\n";
}

/// The same with what Markdown has around its mathematics.
std::string sound_markdown(Random& random) {
  static const std::vector<std::string> between = {
      "Code `$m = 3$` and ``a ` b``, 100% of it.\n",
      "```tex\n" + block("m = 4") + "```\n",
      "~~~~\n$$m = 5$$\n```\n\n~~~~\n",
      "<!-- \\[m = 6\\] -->\n",
      "<!-- texbrdf: allow E3013 -->\n",
      "It costs $5 and $6, or 5\\$ and `$`.\n",
  };
  std::string text = sound_document(random);
  for (size_t at = text.find("\nTerm number"); at != std::string::npos; at = text.find("\nTerm number", at)) {
    const std::string& piece = between[random() % between.size()];
    text.insert(at + 1, piece);
    at += piece.size() + 1;
  }
  return text;
}

/// Edits as people make them, and as nobody should.
class Editor {
 public:
  Editor(Document& document, FileId file, std::string text, unsigned seed)
      : document_(document), file_(file), text_(std::move(text)), random_(seed) {}

  const std::string& text() const { return text_; }

  void step() {
    // More often than not the last edit is taken back: most states of a document that is written are sound.
    if (!undo_.empty() && below(100) < 65) {
      undo();
    } else if (below(100) < 55) {
      sound_edit();
    } else {
      wild_edit();
    }
  }

  /// Back to the text of the beginning.
  void undo_all() {
    while (!undo_.empty()) undo();
  }

 private:
  struct Inverse {
    size_t begin;
    size_t size;
    std::string text;
  };

  size_t below(size_t limit) { return limit == 0 ? 0 : random_() % limit; }

  void replace(size_t begin, size_t size, const std::string& by) {
    undo_.push_back({begin, by.size(), text_.substr(begin, size)});
    apply(begin, size, by);
  }
  void apply(size_t begin, size_t size, const std::string& by) {
    text_.replace(begin, size, by);
    document_.replace(file_, {static_cast<uint32_t>(begin), static_cast<uint32_t>(begin + size)}, by);
  }
  void undo() {
    const Inverse last = undo_.back();
    undo_.pop_back();
    apply(last.begin, last.size, last.text);
  }

  size_t find_from_anywhere(std::string_view wanted) {
    const size_t found = text_.find(wanted, below(text_.size()));
    return found == std::string::npos ? text_.find(wanted) : found;
  }

  void sound_edit() {
    switch (below(6)) {
      case 0: {
        const size_t digit = text_.find_first_of("123456789", below(text_.size()));
        const bool is_number = digit != std::string::npos && digit > 0 && text_[digit - 1] == '.';
        if (is_number) replace(digit, 1, std::to_string(1 + below(9)));
        return;
      }
      case 1: {
        const size_t line = find_from_anywhere("\n\\begin{equation}");
        if (line != std::string::npos) replace(line, 0, "\nMore prose.");
        return;
      }
      case 2: {
        const size_t line = find_from_anywhere("\nTerm number");
        if (line != std::string::npos) replace(line, 0, "\n" + block("z_{" + std::to_string(++fresh_) + "} = m + 1"));
        return;
      }
      case 3: {
        static const std::vector<std::string> lines = {
            "\\renewcommand{\\scale}{0.25}", "\\let\\theta\\vartheta",          "\\newcommand{\\unused}{m}",
            "\\def\\scaled#1{#1}",           "$$\\newcommand{\\scale}{0.75}$$", "\\providecommand{\\scale}{2}"};
        const size_t line = find_from_anywhere("\nTerm number");
        if (line != std::string::npos) replace(line, 0, "\n" + lines[below(lines.size())]);
        return;
      }
      case 4: {
        static const std::vector<std::string> arguments = {"\\omega_o", "\\vec{n}", "m", "\\rho_d", "x", "y"};
        const std::string& argument = arguments[below(arguments.size())];
        const size_t place = find_from_anywhere(argument);
        if (place != std::string::npos) replace(place, argument.size(), arguments[below(arguments.size())]);
        return;
      }
      default: {
        const size_t plus = find_from_anywhere(" + ");
        if (plus != std::string::npos) replace(plus, 3, " - ");
        return;
      }
    }
  }

  void wild_edit() {
    static const std::vector<std::string> pieces = {"%",
                                                    "\\begin{equation}",
                                                    "\\end{equation}",
                                                    "{",
                                                    "}",
                                                    "$",
                                                    "$$",
                                                    "\\[",
                                                    "\\]",
                                                    "\\\\",
                                                    "&",
                                                    ", \\quad b = ",
                                                    "\\text{where }",
                                                    "\\begin{align}",
                                                    "\\end{align}",
                                                    " so $a_{8} = 0.25$ ",
                                                    "\\rho_d",
                                                    "wm",
                                                    "\\Delta ",
                                                    "\\vec{u}",
                                                    "D",
                                                    "wz = 3 + D",
                                                    "a_{7}",
                                                    "f",
                                                    "\\begin{cases}",
                                                    "\\end{cases}",
                                                    "\\left\\{\\begin{array}{l} 2 & m > 1 \\\\ ",
                                                    "\\end{array}",
                                                    "\\text{otherwise}",
                                                    "\\begin{cases} m & m > a_{7} \\\\ 2 \\end{cases}",
                                                    "\\chi^+(m)",
                                                    "\n" + block("\\chi^+(x) = 2 x"),
                                                    "(",
                                                    ")",
                                                    "\n\n",
                                                    "\\vec{",
                                                    "\\sin",
                                                    "\\",
                                                    "= ",
                                                    "\\begin{verbatim}",
                                                    "\\end{verbatim}",
                                                    "m",
                                                    "\\theta_h",
                                                    "\\input",
                                                    "\\input{part}",
                                                    "\\end{document}",
                                                    "% texbrdf: root = a_{3}\n",
                                                    "\r\n",
                                                    "% texbrdf: ignore\n",
                                                    "% texbrdf: allow E3013\n",
                                                    "ω",
                                                    "\xff",
                                                    "\n" + block("m = 2"),
                                                    "\n" + block("m(x) = x"),
                                                    "m(",
                                                    "(x) = ",
                                                    "'",
                                                    "\\mathbf{u}",
                                                    "\\scale",
                                                    "\\scaled",
                                                    "\\scaled{",
                                                    "\\newcommand{\\scale}{",
                                                    "\\newcommand{\\m}{m}",
                                                    "\\def\\scale#1{#1}",
                                                    "\\let\\scaled\\scale",
                                                    "\\renewcommand{\\rho}{\\theta_i\\rho}",
                                                    "[1]",
                                                    "#1",
                                                    "{\\bf n}",
                                                    "\\theta_u",
                                                    "\n" + block("n = 2"),
                                                    "\n" + block("\\hat l = \\omega_o"),
                                                    "\n" + block("\\theta_u(x) = x"),
                                                    "\n" + block("a_k = m"),
                                                    "\n" + block("a_{52} = \\vec{n}"),
                                                    "\n" + block("a_{51}(x) = x"),
                                                    "\n" + block("g'(x) = 2"),
                                                    "\\sum_{k=1}^3 a_k ",
                                                    "\\int_0^1 ",
                                                    "\\,dx",
                                                    "_k",
                                                    "\\frac{d}{dm} ",
                                                    "\n" + block("f_r = \\theta_h"),
                                                    " so $m = 0$ and $m = 0.7$ ",
                                                    " costs 5$ and ",
                                                    "\n" + block("r(u - m) = (u - m)^2 + u"),
                                                    "\n" + block("q(y, x) = y + x"),
                                                    "\n" + block("u = 3"),
                                                    "\n" + block("P(x, y) = \\exp(x) y"),
                                                    "\n" + block("P(x, y) = x y"),
                                                    "\n" + block("P(x, y) = U(x, y)"),
                                                    "\n" + block("E(a, b, t) = |a - b| + t"),
                                                    "\n" + block("E(\\vec a, b, t) = \\vec a \\times b"),
                                                    "\n" + block("W(x) = P(x, x)"),
                                                    "U(\\rho_d, ",
                                                    "P(\\omega_i, ",
                                                    "|W(m)|",
                                                    ", \\vec{n})",
                                                    "\n" + block("\\cos m = 0.5"),
                                                    "\n" + block("g = 2"),
                                                    "g^2(",
                                                    "^{(1)}(x)",
                                                    "{f} = f = ",
                                                    "`",
                                                    "``",
                                                    "\n```\n",
                                                    "\n  ````tex\n",
                                                    "\n~~~\n",
                                                    "~",
                                                    "   ",
                                                    "$$a_{9} = 1$$",
                                                    "<!--",
                                                    "-->",
                                                    "<!-- texbrdf: ignore -->\n",
                                                    "<!-- texbrdf: root = a_{4} -->",
                                                    "\n"};
    const size_t at = below(text_.size() + 1);
    switch (below(5)) {
      case 0:
      case 1:
        replace(at, 0, pieces[below(pieces.size())]);
        return;
      case 2:
        replace(at, std::min(text_.size() - at, 1 + below(12)), "");
        return;
      case 3:
        replace(at, std::min(text_.size() - at, below(400)), pieces[below(pieces.size())]);
        return;
      default: {
        // A region moves elsewhere.
        const std::string region = text_.substr(at, below(300));
        replace(at, region.size(), "");
        replace(below(text_.size() + 1), 0, region);
        return;
      }
    }
  }

  Document& document_;
  const FileId file_;
  std::string text_;
  Random random_;
  std::vector<Inverse> undo_;
  int fresh_ = 0;
};

/// How many of the states that were compared had no error.
class Soundness {
 public:
  /// True after so many states in a row with errors that somebody would begin anew.
  bool has_enough(bool is_sound) {
    ++compared_;
    sound_ += is_sound ? 1 : 0;
    unsound_in_a_row_ = is_sound ? 0 : unsound_in_a_row_ + 1;
    return unsound_in_a_row_ >= kPatience;
  }

  void expect_a_third() const {
    std::cout << compared_ << " states compared, " << sound_ << " of them sound\n";
    EXPECT_GE(sound_ * 10, compared_ * 3);
  }

 private:
  static constexpr int kPatience = 8;
  int compared_ = 0;
  int sound_ = 0;
  int unsound_in_a_row_ = 0;
};

unsigned seed_of_this_run() {
  const char* given = std::getenv("TEXBRDF_SEED");
  return given == nullptr ? std::random_device{}() : static_cast<unsigned>(std::strtoul(given, nullptr, 10));
}

void compare_after_edits(TextLanguage language, std::string (*write)(Random&)) {
  const unsigned seed = seed_of_this_run();
  std::cout << "TEXBRDF_SEED=" << seed << '\n';
  constexpr int kRounds = 8;
  constexpr int kSteps = 250;
  Soundness soundness;
  for (int round = 0; round < kRounds; ++round) {
    Random random(seed + static_cast<unsigned>(round));
    const std::string text = write(random);
    Document document(text, language);
    Editor editor(document, FileId{0}, text, random());
    for (int step = 0; step < kSteps; ++step) {
      editor.step();
      if (random() % 5 == 0) continue;  // two edits between snapshots
      Document fresh = Document(editor.text(), language);
      const Snapshot& snapshot = document.snapshot();
      ASSERT_EQ(snapshot.text().bytes(), editor.text());
      ASSERT_EQ(everything_of(snapshot), everything_of(fresh.snapshot()))
          << "TEXBRDF_SEED=" << seed << ", round " << round << ", step " << step << "\n"
          << editor.text();
      if (soundness.has_enough(!snapshot.has_errors() && snapshot.blocks().size() >= 50)) editor.undo_all();
    }
  }
  soundness.expect_a_third();
}

TEST(Incremental, AfterAnyEditsADocumentIsWhatAFreshOneWouldBe) {
  compare_after_edits(TextLanguage::Latex, sound_document);
}

TEST(Incremental, AfterAnyEditsMarkdownIsWhatAFreshOneWouldBe) {
  compare_after_edits(TextLanguage::Markdown, sound_markdown);
}

/// Definitions that use those of `sound_document`.
std::string sound_part(Random& random, const std::string& name) {
  std::string text = "\\section{" + name + "}\n\\input{" + name + "-more}\n";
  for (int i = 0; i < 12; ++i) {
    const std::string term = "a_{" + std::to_string(random() % 55) + "}";
    text += block(name + "_{" + std::to_string(i) + "} = g(" + term + ") + " + std::to_string(i));
  }
  return text;
}

Document project_of(const std::vector<Editor>& files) {
  Document document(files.front().text());
  for (uint32_t file = 1; file < files.size(); ++file) {
    document.insert_file({file}, SourceText(files[file].text()));
  }
  return document;
}

TEST(Incremental, AfterAnyEditsAProjectIsWhatAFreshOneWouldBe) {
  const unsigned seed = seed_of_this_run();
  std::cout << "TEXBRDF_SEED=" << seed << '\n';
  constexpr int kRounds = 3;
  constexpr int kSteps = 120;
  Soundness soundness;
  for (int round = 0; round < kRounds; ++round) {
    Random random(seed + static_cast<unsigned>(round));
    const std::vector<std::string> texts = {sound_document(random), sound_part(random, "p"), sound_part(random, "q")};
    Document document(texts.front());
    std::vector<Editor> files;
    for (uint32_t file = 0; file < texts.size(); ++file) {
      if (file > 0) document.insert_file({file}, SourceText(texts[file]));
      files.emplace_back(document, FileId{file}, texts[file], random());
    }
    for (int step = 0; step < kSteps; ++step) {
      files[random() % 2].step();  // were all edited, few states would be sound
      if (random() % 16 == 0) {    // a file goes, and comes back
        const auto file = static_cast<uint32_t>(1 + random() % 2);
        document.remove_file({file});
        if (random() % 2 == 0) document.snapshot();
        document.insert_file({file}, SourceText(files[file].text()));
      }
      if (random() % 5 == 0) continue;
      Document fresh = project_of(files);
      for (uint32_t seen = 0; seen < files.size(); ++seen) {
        const Snapshot& snapshot = document.snapshot({seen});
        ASSERT_EQ(snapshot.text().bytes(), files[seen].text());
        ASSERT_EQ(document.includes({seen}), fresh.includes({seen}));
        ASSERT_EQ(everything_of(snapshot), everything_of(fresh.snapshot({seen})))
            << "TEXBRDF_SEED=" << seed << ", round " << round << ", step " << step << ", file " << seen;
      }
      if (!soundness.has_enough(!document.snapshot().has_errors())) continue;
      for (Editor& file : files) file.undo_all();
    }
  }
  soundness.expect_a_third();
}

}  // namespace
}  // namespace texbrdf
