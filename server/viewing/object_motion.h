#pragma once

#include <set>
#include <string>

#include "scene/scene.h"

namespace texbrdf::viewing {

/// Keys that are held, called as KeyBinding calls them.
using HeldKeys = std::set<std::string, std::less<>>;

/// Where an object is after so many seconds with keys held. Keys of one object add up.
scene::Transform moved(const scene::Transform& from, const scene::Dynamic& dynamic, const HeldKeys& held,
                       double seconds);

/// Moves all dynamic objects; false where none has another place than before.
bool move_objects(scene::Scene& scene, const HeldKeys& held, double seconds);

/// Whether some object is moved by the key.
bool binds(const scene::Scene& scene, std::string_view key);

}  // namespace texbrdf::viewing
