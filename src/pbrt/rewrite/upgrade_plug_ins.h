#pragma once

#include <string>

#include "pbrt/rewrite/statement.h"

namespace pbrt::rewrite {

// The parameters of one directive, from pbrt-v3's to pbrt-v4's. `type` is the plug-in's name, which
// the table of old names has renamed already; parameters have their old names still.

void UpgradeAreaLight(std::string *type, Statement *s, Diagnostics *log);
void UpgradeCamera(std::string *type, Statement *s, Diagnostics *log);
void UpgradeFilm(std::string *type, Statement *s, Diagnostics *log);
void UpgradeFilter(std::string *type, Statement *s, Diagnostics *log);
void UpgradeIntegrator(std::string *type, Statement *s, Diagnostics *log);
void UpgradeLight(std::string *type, Statement *s, Diagnostics *log);
/// In upgrade_material.cpp; it renames the plug-in by itself, as its parameters depend on what it
/// was.
void UpgradeMaterial(std::string *type, Statement *s, Diagnostics *log);
void UpgradeSampler(std::string *type, Statement *s, Diagnostics *log);
void UpgradeShape(std::string *type, Statement *s, Diagnostics *log);
void UpgradeTexture(std::string *type, Statement *s, Diagnostics *log);

/// The one number of a "float", or of an "rgb" of three equal ones.
std::optional<float> GrayOf(const Parameter &p);
/// Removes the parameter, with a warning where it is not `silent`, the value that changes nothing.
void Drop(std::string_view name, std::optional<float> silent, Statement *s, Diagnostics *log);
/// Writes the number as short as it can be read back.
std::string Written(float number);

}  // namespace pbrt::rewrite
