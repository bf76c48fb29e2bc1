// SPDX-License-Identifier: MIT
// lab_scene.h -- makes a lab from a scene file.
#ifndef LAB_SCENE_H
#define LAB_SCENE_H
#include "lab.h"
#include "scene/scene.h"

// Opens a lab with the bodies of a scene, its duration of a step and its substeps; never returns null. If the scene
// does not exist, the validation ends. setting: another value for a parameter of the scene, or null.
Lab* lab_scene(Validation* validation, const char* name, const SceneSetting* setting);

#endif
