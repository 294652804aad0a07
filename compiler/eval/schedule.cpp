#include "eval/schedule.h"

#include <algorithm>

#include "eval/regions.h"
#include "source/internal_error.h"

namespace texbrdf::eval {

namespace {

using ir::Op;
using ir::ValueId;

/// Decides the region of every value. Users have higher ids than their operands, so one walk from the last value down
/// knows all uses of a value when it comes to it.
class Placement {
 public:
  explicit Placement(const ir::Graph& graph)
      : graph_(graph), region_(graph.size(), kNoRegion), first_inner_(graph.size(), kNoRegion) {
    for (const ValueId root : graph.roots) use(root, kRootRegion);
    for (uint32_t i = graph.size(); i-- > 0;) {
      if (region_[i] != kNoRegion) place({i});
    }
  }

  /// kNoRegion for a value that no root needs.
  RegionId region(ValueId value) const { return region_[value.value]; }
  /// Of a Select: the region of its true branch, that of the false branch follows. Of a reduction: its body.
  RegionId first_inner(ValueId value) const { return first_inner_[value.value]; }
  uint32_t region_count() const { return regions_.size(); }

 private:
  void use(ValueId value, RegionId by) {
    RegionId& region = region_[value.value];
    region = region == kNoRegion ? by : regions_.common_ancestor(region, by);
  }

  void place(ValueId value) {
    const ir::Value& v = graph_.at(value);
    RegionId& region = region_[value.value];
    region = regions_.outside_of_loops(region, v.binders);
    require((v.binders & ~regions_.binders(region)) == 0, "a value outside of the reduction it depends on");
    const auto operands = graph_.operands(value);
    if (v.op == Op::Select) {
      const RegionId if_true = regions_.add_branch(region);
      const RegionId if_false = regions_.add_branch(region);
      first_inner_[value.value] = if_true;
      use(operands[0], region);
      use(operands[1], if_true);
      use(operands[2], if_false);
    } else if (v.op == Op::Sum || v.op == Op::Product) {
      const RegionId body = regions_.add_loop(region, v.index);
      first_inner_[value.value] = body;
      use(operands[0], region);
      use(operands[1], region);
      use(operands[2], body);
    } else {
      for (const ValueId operand : operands) use(operand, region);
    }
  }

  const ir::Graph& graph_;
  RegionTree regions_;
  std::vector<RegionId> region_;
  std::vector<RegionId> first_inner_;
};

/// Writes the steps: the values of a region by ascending id, the regions of a value right before it.
class Writer {
 public:
  explicit Writer(const ir::Graph& graph) : graph_(graph), placement_(graph), computed_at_(graph.size(), 0) {
    collect_members();
  }

  Schedule write() {
    push_members(kRootRegion);
    while (!tasks_.empty()) {
      const Task task = tasks_.back();
      tasks_.pop_back();
      run(task);
    }
    for (const ValueId root : graph_.roots) schedule_.root_end.push_back(computed_at_[root.value] + 1);
    return std::move(schedule_);
  }

 private:
  struct Task {
    enum class Kind : uint8_t { Visit, Enter, Leave, Compute };
    Kind kind;
    ValueId value;
    Step::Kind opening = Step::Kind::Compute;  ///< of Enter and Leave
    uint32_t opened_at = 0;                    ///< of Leave: the step that opened the region
  };

  void collect_members() {
    members_begin_.assign(placement_.region_count() + 1, 0);
    for (uint32_t i = 0; i < graph_.size(); ++i) {
      const RegionId region = placement_.region({i});
      if (region != kNoRegion) ++members_begin_[region + 1];
    }
    for (uint32_t r = 0; r < placement_.region_count(); ++r) members_begin_[r + 1] += members_begin_[r];
    members_.resize(members_begin_.back());
    std::vector<uint32_t> next = members_begin_;
    for (uint32_t i = 0; i < graph_.size(); ++i) {
      const RegionId region = placement_.region({i});
      if (region != kNoRegion) members_[next[region]++] = {i};
    }
  }

  bool is_empty(RegionId region) const { return members_begin_[region] == members_begin_[region + 1]; }

  RegionId region_of(Task task) const {
    const RegionId first = placement_.first_inner(task.value);
    return task.opening == Step::Kind::IfFalse ? first + 1 : first;
  }

  /// Tasks are a stack: what is to come first is pushed last.
  void push_members(RegionId region) {
    for (uint32_t i = members_begin_[region + 1]; i-- > members_begin_[region];) {
      tasks_.push_back({.kind = Task::Kind::Visit, .value = members_[i]});
    }
  }

  void run(Task task) {
    switch (task.kind) {
      case Task::Kind::Visit:
        visit(task.value);
        break;
      case Task::Kind::Enter:
        tasks_.push_back({.kind = Task::Kind::Leave,
                          .value = task.value,
                          .opening = task.opening,
                          .opened_at = static_cast<uint32_t>(schedule_.steps.size())});
        schedule_.steps.push_back({task.opening, task.value});
        push_members(region_of(task));
        break;
      case Task::Kind::Leave:
        leave(task);
        break;
      case Task::Kind::Compute:
        compute(task.value);
        break;
    }
  }

  void visit(ValueId value) {
    const RegionId inner = placement_.first_inner(value);
    if (inner == kNoRegion) return compute(value);
    if (graph_.at(value).op != Op::Select) return enter(value, Step::Kind::BeginLoop);
    tasks_.push_back({.kind = Task::Kind::Compute, .value = value});
    if (!is_empty(inner + 1)) enter(value, Step::Kind::IfFalse);
    if (!is_empty(inner)) enter(value, Step::Kind::IfTrue);
  }

  void enter(ValueId value, Step::Kind opening) {
    tasks_.push_back({.kind = Task::Kind::Enter, .value = value, .opening = opening});
  }

  void leave(Task task) {
    if (task.opening == Step::Kind::BeginLoop) {
      computed_at_[task.value.value] = static_cast<uint32_t>(schedule_.steps.size());
      schedule_.steps.push_back({Step::Kind::EndLoop, task.value, task.opened_at + 1});
    }
    schedule_.steps[task.opened_at].target = static_cast<uint32_t>(schedule_.steps.size());
  }

  void compute(ValueId value) {
    computed_at_[value.value] = static_cast<uint32_t>(schedule_.steps.size());
    schedule_.steps.push_back({Step::Kind::Compute, value});
  }

  const ir::Graph& graph_;
  Placement placement_;
  std::vector<uint32_t> members_begin_;  ///< by region, into members_
  std::vector<ValueId> members_;
  std::vector<uint32_t> computed_at_;
  std::vector<Task> tasks_;
  Schedule schedule_;
};

}  // namespace

Schedule schedule(const ir::Graph& graph) {
  return Writer(graph).write();
}

}  // namespace texbrdf::eval
