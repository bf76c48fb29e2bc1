// SPDX-License-Identifier: MIT
// handles.h -- converts slots to handles and back.
#ifndef HANDLES_H
#define HANDLES_H
#include "step/step_queries.h"
#include "world/check.h"

scree_body body_handle(const scree_world* world, int index);
scree_collidable collidable_handle(const scree_world* world, int index);
scree_attribute attribute_handle(const scree_world* world, int index);
scree_joint joint_handle(const scree_world* world, int index);
scree_path path_handle(const scree_world* world, int index);
scree_field field_handle(const scree_world* world, int index);

// Returns the handle of the body of a collidable; a null handle if the collidable has no body.
scree_body owner_handle(const scree_world* world, int collidable);

bool body_is_valid(const scree_world* world, scree_body body);
bool collidable_is_valid(const scree_world* world, scree_collidable collidable);
bool attribute_is_valid(const scree_world* world, scree_attribute attribute);
bool joint_is_valid(const scree_world* world, scree_joint joint);
bool path_is_valid(const scree_world* world, scree_path path);
bool field_is_valid(const scree_world* world, scree_field field);

// Check a handle, and set *index to its slot. Fail with SCREE_ERROR_STALE for a null or invalid handle.
scree_status check_body(const scree_world* world, ArgumentPlace at, const char* member, scree_body body, int* index);
scree_status check_joint(const scree_world* world, ArgumentPlace at, scree_joint joint, int* index);
scree_status check_path(const scree_world* world, ArgumentPlace at, const char* member, scree_path path, int* index);
scree_status check_field(const scree_world* world, ArgumentPlace at, scree_field field, int* index);
scree_status check_collidable(const scree_world* world, ArgumentPlace at, scree_collidable collidable, int* index);

// Checks a handle of a body that may have been destroyed. Refuses null, and a handle that this world never returned.
scree_status check_body_once(const scree_world* world, ArgumentPlace at, const char* member, scree_body body);

Names collidable_names(const scree_world* world);
Names body_names(const scree_world* world);
scree_status check_attribute(const scree_world* world, ArgumentPlace at, const char* member, scree_attribute attribute,
                             int* index);

#endif
