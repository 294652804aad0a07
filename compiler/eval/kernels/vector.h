// Vector registers for one instruction set. Included by each kernel with TEXBRDF_LANES defined: everything here has
// internal linkage, because each kernel is compiled with other flags.

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"  // g++ 12 about its own AVX-512 header, when that is inlined
#include <immintrin.h>
#pragma GCC diagnostic pop

namespace texbrdf::eval {
namespace {

constexpr Index kLanes = TEXBRDF_LANES;

using Vector = float __attribute__((vector_size(4 * kLanes)));
using Mask = int __attribute__((vector_size(4 * kLanes)));  ///< all ones or all zeros in each lane

inline Vector load(const Slot& slot, Index lane) {
  Vector v;
  __builtin_memcpy(&v, slot.data + lane * slot.stride, sizeof v);
  return v;
}

inline void store(const Slot& slot, Index lane, Vector v) {
  __builtin_memcpy(slot.data + lane, &v, sizeof v);
}

inline Mask bits(Vector v) {
  return reinterpret_cast<Mask>(v);
}

inline Vector from_bits(Mask m) {
  return reinterpret_cast<Vector>(m);
}

inline Vector all(float x) {
  return x - Vector{};
}

inline Vector choose(Mask condition, Vector a, Vector b) {
  return condition ? a : b;
}

inline Vector absolute(Vector v) {
  return from_bits(bits(v) & 0x7fffffff);
}

inline Vector square_root(Vector v) {
#if TEXBRDF_LANES == 4
  return _mm_sqrt_ps(v);
#elif TEXBRDF_LANES == 8
  return _mm256_sqrt_ps(v);
#else
  return _mm512_sqrt_ps(v);
#endif
}

inline bool any(Mask m) {
  int lanes[kLanes];
  __builtin_memcpy(lanes, &m, sizeof m);
  int joined = 0;
  for (const int lane : lanes) joined |= lane;
  return joined != 0;
}

/// NaN if either is NaN; of +0 and -0 the first.
inline Vector minimum(Vector a, Vector b) {
  return choose(b != b, b, choose(b < a, b, a));
}

inline Vector maximum(Vector a, Vector b) {
  return choose(b != b, b, choose(b > a, b, a));
}

/// Which lanes hold integers, and which of those odd ones.
struct Parity {
  Mask integer;
  Mask odd;
};

inline Parity parity(Vector v) {
  constexpr float kAllIntegers = 8388608;  // 2^23: from here on every number is an integer
  constexpr float kAllEven = 16777216;
  const Mask small = absolute(v) < kAllEven;
  const Mask truncated = __builtin_convertvector(choose(small, v, Vector{}), Mask);
  const Mask whole = small & (__builtin_convertvector(truncated, Vector) == v);
  const Mask large = (absolute(v) >= kAllIntegers) & (absolute(v) < __builtin_inff());
  return {whole | large, whole & (-(truncated & 1))};
}

}  // namespace
}  // namespace texbrdf::eval
