#pragma once

// The complete Json, for the sources that take it apart. Headers include json_document.h instead.
#include <nlohmann/json.hpp>

#include "core/gltf/json/json_document.h"
