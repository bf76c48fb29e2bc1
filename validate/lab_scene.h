// SPDX-License-Identifier: MIT
// lab_scene.h -- a scene file as a lab.
#ifndef LAB_SCENE_H
#define LAB_SCENE_H
#include "lab.h"
#include "scene/scene.h"

// Never returns null. Ends the validation if there is no such scene. The lab has the step and the substeps of the scene; setting
// gives a parameter another value, or is null.
Lab* lab_scene(Validation* validation, const char* name, const SceneSetting* setting);

#endif
