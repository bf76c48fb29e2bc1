// SPDX-License-Identifier: MIT
// caption.h -- the caption of a picture, beside its title.
#ifndef CAPTION_H
#define CAPTION_H
#include "scene/scene.h"

// Writes the name of a world's device; for the CPU with threads and lanes.
void device_text(const scree_world* world, char* text, size_t size);

// Writes the caption of a picture that is kept: its step and the hash of the world, then the text of caption_text.
void caption_exact(const Scene* scene, const scree_world* world, const scree_counters* counters, uint64_t hash,
                   char* text, size_t size);

// Writes time, bodies, contacts and device.
void caption_text(const Scene* scene, const scree_world* world, const scree_counters* counters, char* text,
                  size_t size);

#endif
