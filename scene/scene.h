// SPDX-License-Identifier: MIT
// scene.h -- a scene that was read from a file. scenes/scene.schema.json describes the format of files.
#ifndef SCENE_H
#define SCENE_H
#include "scree/scree.h"
#include <stdio.h>

#define SCENE_MAX_BODIES 20000000 // and collidables, and joints
#define SCENE_SENTENCE   512      // characters of an error message
#define SCENE_PATH       1024     // characters of a path

typedef struct Block Block;                   // scene/block.h
typedef struct JointBlock JointBlock;         // scene/joint_block.h
typedef struct Attribute Attribute;           // scene/attribute_block.h
typedef struct ScenePath ScenePath;           // scene/path_block.h
typedef struct SceneMaterials SceneMaterials; // scene/material_block.h
typedef struct SceneField SceneField;         // scene/field_block.h
typedef struct SceneBlast SceneBlast;
typedef struct Fan Fan;             // scene/lidar.h
typedef struct Control Control;     // scene/controls.h
typedef struct Character Character; // scene/character.h

typedef struct
{
	char name[64];
	char title[160];
	scree_world_def world; // the caller sets device, threads and lanes
	float dt;              // s
	int substeps;
	int steps;               // of a run, unless the user chooses
	float penetration_limit; // m: a run with deeper overlaps is invalid
	bool has_view;
	scree_box view; // m: what a picture shows
	bool has_detail;
	scree_box detail; // m: the part that a wide picture also shows magnified
	int body_count, collidable_count, joint_count;

	uint64_t seed;
	Attribute* attributes;
	int attribute_count;
	ScenePath* paths;
	int path_count;
	SceneMaterials* materials;
	int material_count;
	SceneField* fields;
	int field_count;
	SceneBlast* blasts;
	int blast_count;
	Block* blocks; // of bodies, then of collidables without a body
	int block_count;
	JointBlock* joint_blocks;
	int joint_block_count;
	Control* controls;
	int control_count;
	Character* characters;
	int character_count;
	Fan* fans;
	int fan_count, ray_count; // rays after each step, of all bodies
} Scene;

typedef struct // --set NAME=VALUE
{
	const char* name;
	const char* value; // a number or an expression without names
} SceneSetting;

#endif
