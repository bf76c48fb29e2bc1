// SPDX-License-Identifier: MIT
// fields.h -- keeps the slots of fields, and uploads the active fields.
#ifndef FIELDS_H
#define FIELDS_H
#include "pools/pools.h"
#include "world/world.h"

scree_status fields_reserve(scree_world* world, const char* function);

// field_make returns a new slot. field_put sets a checked definition. body: body that carries the field, -1 for none.
int field_make(scree_world* world);
void field_put(scree_world* world, int index, const scree_field_def* def, int body);
void field_remove(scree_world* world, int index);

// Remove the fields of a body that will be destroyed; mark fields for the upload if a body was enabled or disabled.
void fields_body_gone(scree_world* world, int body);
void fields_body_changed(scree_world* world, int body);
scree_status upload_fields(scree_world* world);

// Returns the number of active fields at the last upload. *shapes: set to whether one of them acts on shapes.
int fields_acting(const scree_world* world, bool* shapes);

uint64_t fields_hash(const scree_world* world);
void fields_close(scree_world* world);

#endif
