#pragma once

#include <vector>

#include "scene/scene.h"

namespace texbrdf::scene {

/// By node: the largest slope that the node's formula has, if its children have slopes of at most 1, where it or its
/// children are not further than they say; infinite for a twist or bend of unbounded children. A value is divided by
/// no less than this before anything else sees it, so that its slope is at most 1.
///
/// Rotation, translation, mirroring, clamping (symmetry, elongation, revolution, repetition) do not lengthen vectors,
/// and min, max, |x|, x − r do not steepen slopes: 1. Extrusion is the length of two such in orthogonal directions: 1.
/// The smooth operations' derivatives are weights h and 1 − h of their children's: 1. A scale (x, y, z) makes slopes at
/// most 1 / min(|x|, |y|, |z|) as large, and the value is multiplied with that (frame.h): 1.
std::vector<double> lipschitz_bounds(const Scene& scene);

/// 1 + |amplitude · frequency|: with u = sin²(f x), v, w, the gradient of sin · sin · sin has the squared length
/// f² (uv + vw + uw − 3 uvw), which is linear in each and so largest in a corner of [0, 1]³: f².
double displacement_slope(double amplitude, double frequency);
/// The norm of the shear [1, k r; 0, 1], which turning by k y about the y axis is at a radius r: (a + √(a² + 4)) / 2, a
/// = |k| r.
double twist_slope(double k, double radius);
/// Turning by k x about the z axis changes a step in x by k (y, −x) besides: at most 1 + |k| r, which x = 0 attains.
double bend_slope(double k, double radius);

}  // namespace texbrdf::scene
