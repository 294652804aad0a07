#include "features/rename.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "eval/evaluate.h"
#include "features/places.h"
#include "model.h"

namespace texbrdf::test {
namespace {

/// Names that no model has.
constexpr std::string_view kNewName = "\\text{new}";
constexpr std::string_view kNewRootName = "f_{\\text{new}}";
constexpr std::string_view kNewVectorName = "\\vec{\\text{new}}";

/// Codes and places of the diagnostics; the places in the text before the edits. Without the hint that the definition
/// of a name hides the convention: it ends with the name.
using Found = std::vector<std::pair<std::string, uint32_t>>;

uint32_t place_before(uint32_t offset, const std::vector<features::TextEdit>& edits) {
  int64_t grown = 0;
  for (const features::TextEdit& edit : edits) {
    if (edit.span.begin + grown >= offset) break;
    grown += static_cast<int64_t>(edit.text.size()) - edit.span.size();
  }
  return static_cast<uint32_t>(offset - grown);
}

Found diagnostics_of(const std::string& text, const std::vector<features::TextEdit>& edits) {
  Document document(text);
  Found found;
  for (const Diagnostic& diagnostic : document.snapshot().diagnostics()) {
    if (diagnostic.code == Code::ConventionRedefined) continue;
    const Span span = document.snapshot().absolute(diagnostic.where);
    found.emplace_back(code_name(diagnostic.code), place_before(span.begin, edits));
  }
  return found;
}

std::vector<eval::Triple> values_of(const std::string& text, const std::vector<ReferenceRow>& rows) {
  const auto model = compile_text(text);
  std::vector<eval::Triple> values;
  if (!model) return values;
  const eval::ReferenceEvaluator evaluator(model->unoptimised);
  for (const ReferenceRow& row : rows) values.push_back(evaluator.evaluate(row.geometry, model->parameters));
  return values;
}

std::string applied(std::string text, const std::vector<features::TextEdit>& edits) {
  for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
    text.replace(edit->span.begin, edit->span.size(), edit->text);
  }
  return text;
}

class ModelRename : public testing::TestWithParam<std::string> {
 protected:
  /// Renames what stands at the offset and compares what the document then says.
  void expect_the_same(uint32_t offset, std::string_view new_name) {
    const auto edits = features::rename(document_.snapshot(), offset, new_name);
    if (!edits) {
      // c(\omega_i) = \cos\theta_i: by another name of the parameter the angle would be another.
      EXPECT_NE(edits.error().find("because of its name"), std::string::npos) << edits.error();
      return;
    }
    ASSERT_GE(edits->size(), 1u);
    const std::string renamed = applied(text_, *edits);
    ASSERT_NE(renamed, text_);
    EXPECT_EQ(diagnostics_of(renamed, *edits), diagnostics_of(text_, {})) << renamed;
    EXPECT_EQ(values_of(renamed, rows_), values_) << renamed;
  }

  std::string text_ = read_text(model_path(GetParam(), ".tex"));
  std::vector<ReferenceRow> rows_ = read_reference(GetParam());
  std::vector<eval::Triple> values_ = values_of(text_, rows_);
  Document document_{text_};
};

TEST_P(ModelRename, EveryDefinitionKeepsDiagnosticsAndValues) {
  ASSERT_FALSE(values_.empty());
  const Snapshot& snapshot = document_.snapshot();
  for (uint32_t id = 0; id < snapshot.definitions().size(); ++id) {
    const bool is_root = snapshot.names().text(snapshot.definition(DefinitionId{id}).name) == snapshot.root_name();
    expect_the_same(features::name_span(snapshot, DefinitionId{id}).begin, is_root ? kNewRootName : kNewName);
  }
}

TEST_P(ModelRename, EveryParameterKeepsDiagnosticsAndValues) {
  const Snapshot& snapshot = document_.snapshot();
  for (uint32_t id = 0; id < snapshot.definitions().size(); ++id) {
    const Definition& definition = snapshot.definition(DefinitionId{id});
    for (const CheckedParameter& parameter : definition.checked->parameters) {
      const uint32_t offset = features::node_span(snapshot, definition.block, parameter.node).begin;
      const bool is_vector = snapshot.names().traits(parameter.name).is_vector;
      expect_the_same(offset, is_vector ? kNewVectorName : kNewName);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ModelRename, testing::ValuesIn(model_names()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace texbrdf::test
