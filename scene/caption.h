// SPDX-License-Identifier: MIT
// caption.h -- what is written beside the title of a picture.
#ifndef CAPTION_H
#define CAPTION_H
#include "scene/scene.h"

// The device of a world, for the CPU with its threads and lanes.
void device_text(const scree_world* world, char* text, size_t size);

// Time, bodies, contacts, device.
void caption_text(const Scene* scene, const scree_world* world, const scree_counters* counters, char* text,
                  size_t size);

#endif
