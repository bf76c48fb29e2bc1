// SPDX-License-Identifier: MIT
// contents.h -- lists the objects of a world that a scene file gets, and their names in the file.
#ifndef CONTENTS_H
#define CONTENTS_H
#include "scene/writer.h"

typedef struct
{
	int a, b; // positions in Contents.bodies
} BodyPair;

typedef struct // all lists are in ascending index order of the objects
{
	scree_world* world;
	scree_world_def def;
	int64_t steps; // number of steps that the world has taken

	scree_attribute_def* attributes;
	int attribute_count;
	int* attribute_at; // by index of a handle: position in `attributes`

	scree_body* bodies;
	scree_body_state* states;
	bool* named; // true: a joint, a field or an excluded pair refers to the body
	int body_count;
	int* body_at; // by index of a handle: position in `bodies`

	scree_collidable* collidables; // collidables of one body
	int collidable_capacity;

	scree_path* paths;
	int path_count;
	int* path_at; // by index of a handle: position in `paths`
	scree_joint* joints;
	scree_joint_state* joint_states;
	int joint_count;
	scree_field* fields;
	int field_count;
	BodyPair* exclusions; // each pair once
	int exclusion_count;
} Contents;

// Lists the objects of a world. The caller closes the contents also on failure.
bool contents_open(Contents* contents, Writer* writer, scree_world* world);
void contents_close(Contents* contents);

// Lists the collidables of a body into Contents.collidables; null: those without a body.
bool contents_collidables(Contents* contents, Writer* writer, scree_body body, int* count);

// Write the name of an attribute, or of a body or a path by its position, as a string.
void contents_attribute_name(const Contents* contents, Text* text, int position);
void contents_name(Text* text, const char* kind, int position);

// Writes a member that refers to a body, or null: {"body": "body_3"}.
void contents_end(const Contents* contents, Text* text, const char* key, scree_body body);

// Adds a region of a field as an attribute, unless one has this shape. Sets *position.
bool contents_region(Contents* contents, Writer* writer, const scree_shape* shape, int* position);

#endif
