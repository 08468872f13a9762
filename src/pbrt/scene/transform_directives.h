#pragma once

#include "pbrt/scene/directive_context.h"

// The directives that set the current transformation.
namespace pbrt {

void ReadActiveTransform(DirectiveContext &c);
void ReadConcatTransform(DirectiveContext &c);
void ReadCoordSysTransform(DirectiveContext &c);
void ReadCoordinateSystem(DirectiveContext &c);
void ReadIdentity(DirectiveContext &c);
void ReadLookAt(DirectiveContext &c);
void ReadRotate(DirectiveContext &c);
void ReadScale(DirectiveContext &c);
void ReadTransform(DirectiveContext &c);
void ReadTransformTimes(DirectiveContext &c);
void ReadTranslate(DirectiveContext &c);

}  // namespace pbrt
