#include <gtest/gtest.h>

#include "analysis/document.h"

namespace texbrdf {
namespace {

constexpr std::string_view kMain = "\\input{a}\n\\begin{equation}f = g(m)\\end{equation}\n";
constexpr std::string_view kPart =
    "\\begin{equation}g(x) = x * \\theta_h\\end{equation}\n\\begin{equation}m = 2\\end{equation}";

Document project() {
  Document document(kMain);
  document.insert_file({1}, SourceText(kPart));
  return document;
}

std::vector<std::string> codes(const Snapshot& snapshot) {
  std::vector<std::string> all;
  for (const Diagnostic& diagnostic : snapshot.diagnostics()) all.push_back(code_name(diagnostic.code));
  return all;
}

TEST(Project, FilesShareTheirDefinitions) {
  Document alone(kMain);
  EXPECT_TRUE(alone.snapshot().has_errors());
  Document both = project();
  EXPECT_FALSE(both.snapshot().has_errors());
  EXPECT_TRUE(both.snapshot().program());
}

TEST(Project, EachFileIsSeenFromItsOwnBegin) {
  Document document = project();
  const Snapshot& part = document.snapshot({1});
  EXPECT_EQ(part.text().bytes(), kPart);
  EXPECT_EQ(part.blocks().size(), 2u);
  EXPECT_EQ(part.block(BlockId{0}).offset, 0u);
  EXPECT_EQ(part.definitions().size(), 2u);
  EXPECT_EQ(part.all_definitions().size(), 3u);
  EXPECT_EQ(part.block_at(0), BlockId{0});
  EXPECT_EQ(document.snapshot().block_at(3), std::nullopt);
}

TEST(Project, WhatIsFoundElsewhereTellsItsFile) {
  Document document = project();
  const Snapshot& main = document.snapshot();
  const auto use = main.occurrence_at(static_cast<uint32_t>(kMain.find("m)")));
  ASSERT_TRUE(use);
  const std::vector<Occurrence> all = main.occurrences_of(*use);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(main.place(all[0].span).file, FileId{0});
  const FilePlace elsewhere = main.place(all[1].span);
  EXPECT_EQ(elsewhere.file, FileId{1});
  EXPECT_EQ(main.text(elsewhere.file).slice(elsewhere.span), "m");
  EXPECT_EQ(elsewhere.span.begin, kPart.find("m = 2"));
}

TEST(Project, AnEditChecksOnlyWhatItCanAffect) {
  Document document = project();
  document.snapshot();
  const auto two = static_cast<uint32_t>(kPart.find('2'));
  document.replace(FileId{1}, {two, two + 1}, "3");
  const Counters counters = document.snapshot().counters();
  EXPECT_EQ(counters.blocks_scanned, 1u);
  EXPECT_EQ(counters.blocks_parsed, 1u);
  EXPECT_EQ(counters.definitions_checked, 1u);
}

TEST(Project, NothingSpansTwoFiles) {
  Document document("\\begin{equation}f = m");
  document.insert_file({1}, SourceText("+ 2\\end{equation}\n\\begin{equation}m = 1\\end{equation}"));
  EXPECT_EQ(document.snapshot().blocks().size(), 1u);
  EXPECT_EQ(document.snapshot({1}).blocks().size(), 1u);
  EXPECT_EQ(codes(document.snapshot()), std::vector<std::string>{"E2005"});
}

TEST(Project, AnEpilogueEndsWithItsFile) {
  Document document("\\begin{equation}f = m\\end{equation}\\end{document}\\begin{equation}");
  document.insert_file({1}, SourceText("\\begin{equation}m = 1\\end{equation}"));
  EXPECT_FALSE(document.snapshot().has_errors());
}

TEST(Project, EmptyFilesAreFiles) {
  Document document("");
  document.insert_file({1}, SourceText());
  document.insert_file({1}, SourceText());
  document.replace(FileId{1}, {}, "\\begin{equation}f = 1\\end{equation}");
  document.replace(FileId{2}, {}, "\\begin{equation}m = 1\\end{equation}");
  EXPECT_EQ(document.snapshot({1}).blocks().size(), 1u);
  EXPECT_EQ(document.snapshot({2}).blocks().size(), 1u);
  EXPECT_EQ(document.snapshot().blocks().size(), 0u);
  document.remove_file({1});
  EXPECT_EQ(document.snapshot({1}).definitions().size(), 1u);
  EXPECT_EQ(document.snapshot({1}).all_definitions().size(), 1u);
}

TEST(Project, ManyFilesFindRoomForTheirLabels) {
  Document document("\\begin{equation}f = a_{0}\\end{equation}");
  for (uint32_t i = 0; i < 100; ++i) {
    const std::string right = i == 0 ? "1" : "a_{" + std::to_string(i - 1) + "}";
    const std::string text = "\\begin{equation}a_{" + std::to_string(i) + "} = " + right + "\\end{equation}";
    document.insert_file({1}, SourceText(text));
  }
  EXPECT_FALSE(document.snapshot().has_errors());
  EXPECT_EQ(document.snapshot({100}).all_definitions().size(), 101u);
}

TEST(Includes, AreFoundInProseOnly) {
  const Document document(
      "\\input{a} \\include {b/c.tex}\\subfile{d}\n\\import{e/}{f}\\subimport{g}{h} % \\input{i}\n"
      "\\verb|\\input{j}| \\input{\\k} \\input{#1} \\input l \\inputs{m} \\import{n}\n"
      "\\begin{equation}f = 1 \\input{o}\\end{equation}\\input{ p q }\\end{document}\\input{r}");
  std::vector<std::string> found;
  for (const IncludeTarget& target : document.includes()) found.push_back(target.folder + ":" + target.path);
  EXPECT_EQ(found, (std::vector<std::string>{":a", ":b/c.tex", ":d", "e/:f", "g:h", ":p q"}));
}

TEST(Includes, AProblemIsReportedAtItsCommandAndCanBeSilenced) {
  Document document = project();
  document.set_include_problems({{FileId{0}, document.includes().front(), Code::FileNotFound, "a"}});
  ASSERT_EQ(codes(document.snapshot()), std::vector<std::string>{"E0002"});
  const Diagnostic problem = document.snapshot().diagnostics().front();
  EXPECT_EQ(document.snapshot().absolute(problem.where), (Span{0, 9}));
  const Diagnostic seen = document.snapshot({1}).diagnostics().front();
  const FilePlace place = document.snapshot({1}).place(document.snapshot({1}).absolute(seen.where));
  EXPECT_EQ(place.file, FileId{0});
  EXPECT_EQ(place.span, (Span{0, 9}));
  document.replace({0, 0}, "% texbrdf: allow E0002\n");
  EXPECT_TRUE(codes(document.snapshot()).empty());
}

TEST(RootComment, IsReadFromTheFirstLines) {
  EXPECT_EQ(read_root("% !TeX root = ../main.tex\n"), "../main.tex");
  EXPECT_EQ(read_root("x\n%!TEX root=a b.tex \r\n"), "a b.tex");
  EXPECT_EQ(read_root("% !TeX program = xelatex\n% !TeX root = a"), "a");
  EXPECT_EQ(read_root("% !TeX root =\n"), std::nullopt);
  EXPECT_EQ(read_root(std::string(100, '\n') + "% !TeX root = a"), std::nullopt);
}

TEST(Include, ASubfileNamesItsRoot) {
  EXPECT_EQ(read_root("\\documentclass[../main.tex]{subfiles}\n\\begin{document}"), "../main.tex");
  EXPECT_EQ(read_root("% a\n\\documentclass [ % the whole\r\n main ]\n{ subfiles }"), "main");
  EXPECT_EQ(read_root("% !TeX root = a\n\\documentclass[b]{subfiles}"), "a");
  EXPECT_EQ(read_root("\\% \\documentclass[a]{subfiles}"), "a");
  EXPECT_EQ(read_root("\\\\% \\documentclass[a]{subfiles}"), std::nullopt);
  EXPECT_EQ(read_root("%\\documentclass[a]{subfiles}"), std::nullopt);
  for (const char* other : {"\\documentclass[a4paper]{article}", "\\documentclass{subfiles}",
                            "\\documentclass[]{subfiles}", "\\documentclass[a", "\\documentclass[a]{subfiles",
                            "\\documentclass", "\\documentclass{article}\\documentclass[a]{subfiles}"}) {
    EXPECT_EQ(read_root(other), std::nullopt) << other;
  }
}

}  // namespace
}  // namespace texbrdf
