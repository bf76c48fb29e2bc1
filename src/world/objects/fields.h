// SPDX-License-Identifier: MIT
// fields.h -- slots of fields, and those that act, as the device has them.
#ifndef FIELDS_H
#define FIELDS_H
#include "pools/pools.h"
#include "world/world.h"

// Room for one more field.
scree_status fields_reserve(scree_world* world, const char* function);

// Makes a field of a checked definition; or gives the one in a slot another one, on another body or none (-1).
int field_make(scree_world* world);
void field_put(scree_world* world, int index, const scree_field_def* def, int body);
void field_remove(scree_world* world, int index);

// A body is about to be destroyed, or was enabled or disabled.
void fields_body_gone(scree_world* world, int body);
void fields_body_changed(scree_world* world, int body);

// Sends the fields that act, if some changed.
scree_status upload_fields(scree_world* world);

// The fields that act, for a step; *shapes gets whether some act on shapes.
int fields_acting(const scree_world* world, bool* shapes);

uint64_t fields_hash(const scree_world* world);
void fields_close(scree_world* world);

#endif
