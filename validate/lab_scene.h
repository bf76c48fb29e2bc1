// SPDX-License-Identifier: MIT
// lab_scene.h -- a scene file as a lab.
#ifndef LAB_SCENE_H
#define LAB_SCENE_H
#include "lab.h"
#include "scene/scene.h"

// Never null; breaks the validation when there is no such scene. Its step and substeps are the scene's; setting is a parameter
// that has another value, or null.
Lab* lab_scene(Validation* validation, const char* name, const SceneSetting* setting);

#endif
