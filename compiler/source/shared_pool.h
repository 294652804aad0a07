#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <memory_resource>
#include <utility>

namespace texbrdf {

/// Makes shared values that are expected to go about together, several in one allocation: the memory of one is given
/// back with that of its neighbours. Values may be given up by any thread.
template <typename T>
class SharedPool {
 public:
  /// About so many are going to be made.
  explicit SharedPool(size_t expected) : chunk_size_(std::clamp<size_t>(expected, 1, kMaxChunk)) {}

  template <typename... Arguments>
  std::shared_ptr<T> make(Arguments&&... arguments) {
    if (chunk_size_ == 1) return std::make_shared<T>(std::forward<Arguments>(arguments)...);
    open_chunk();
    T* const value = std::construct_at(chunk_->values + chunk_->used, std::forward<Arguments>(arguments)...);
    ++chunk_->used;
    return std::shared_ptr<T>(chunk_, value);
  }

  /// What the next value may hold its content in; it stays as long as the value and its neighbours.
  std::pmr::memory_resource* memory() { return memory(&Chunk::memory); }
  /// The same for the little of it that is read of many values one after the other: there it stands close together.
  std::pmr::memory_resource* dense_memory() { return memory(&Chunk::dense_memory); }

 private:
  // So that one that stays keeps little else.
  static constexpr size_t kMaxChunk = 16;

  struct Chunk {
    explicit Chunk(size_t wanted) : size(wanted), values(std::allocator<T>().allocate(wanted)) {}
    Chunk(const Chunk&) = delete;
    Chunk& operator=(const Chunk&) = delete;
    ~Chunk() {
      std::destroy_n(values, used);
      std::allocator<T>().deallocate(values, size);
    }

    std::pmr::monotonic_buffer_resource memory;
    std::pmr::monotonic_buffer_resource dense_memory;
    const size_t size;
    T* const values;
    size_t used = 0;
  };

  std::pmr::memory_resource* memory(std::pmr::monotonic_buffer_resource Chunk::* kind) {
    if (chunk_size_ == 1) return std::pmr::get_default_resource();
    open_chunk();
    return &(*chunk_.*kind);
  }

  void open_chunk() {
    if (!chunk_ || chunk_->used == chunk_size_) chunk_ = std::make_shared<Chunk>(chunk_size_);
  }

  size_t chunk_size_;
  std::shared_ptr<Chunk> chunk_;
};

}  // namespace texbrdf
