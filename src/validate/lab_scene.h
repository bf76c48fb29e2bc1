// SPDX-License-Identifier: MIT
// lab_scene.h -- a scene file as a lab.
#ifndef LAB_SCENE_H
#define LAB_SCENE_H
#include "lab.h"

// Never null; breaks the validation when there is no such scene. Its step and substeps are the scene's.
Lab* lab_scene(Validation* validation, const char* name);

#endif
