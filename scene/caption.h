// SPDX-License-Identifier: MIT
// caption.h -- writes the caption of a picture. The caption follows the title.
#ifndef CAPTION_H
#define CAPTION_H
#include "scene/scene.h"

// Writes the name of a world's device, and for the CPU the numbers of threads and lanes.
void device_text(const scree_world* world, char* text, size_t size);

// Writes the caption of a picture that is saved to a file: number of steps and world hash, then the text of
// caption_text.
void caption_exact(const Scene* scene, const scree_world* world, const scree_counters* counters, uint64_t hash,
                   char* text, size_t size);

// Writes time, bodies, contacts and device.
void caption_text(const Scene* scene, const scree_world* world, const scree_counters* counters, char* text,
                  size_t size);

#endif
