// SPDX-License-Identifier: MIT
// scene.h -- a scene that was read from a file. scenes/scene.schema.json describes the format of files.
#ifndef SCENE_H
#define SCENE_H
#include "scene/scene_keys.h"
#include "scree/scree.h"
#include <stdio.h>

#define SCENE_MAX_BODIES 20000000 // maximum number of bodies, of collidables, and of joints
#define SCENE_MAX_RAYS   20000000 // maximum number of rays after a step: 64 bytes each
#define SCENE_SENTENCE   512      // characters of an error message
#define SCENE_PATH       1024     // characters of a path
#define MAX_HULL_POINTS  64
#define FULL_TURN        6.283185307f // rad

typedef struct Block Block;                   // scene/block.h
typedef struct JointBlock JointBlock;         // scene/joint_block.h
typedef struct Attribute Attribute;           // scene/attribute_block.h
typedef struct ScenePath ScenePath;           // scene/path_block.h
typedef struct SceneMaterials SceneMaterials; // scene/material_block.h
typedef struct SceneField SceneField;         // scene/field_block.h
typedef struct Cue Cue;                       // scene/character.h

typedef struct // changes of bodies of a block before every step
{
	int moved, replaced; // bodies per step: moved to another place; destroyed and created again there
	scree_pose pose;     // pose without the numbers that differ between bodies
	scree_velocity velocity;
	scree_body_def* items; // all bodies of the block as created first; their attributes are positions in
	                       // Scene.attributes
} Churn;

typedef struct // an explosion
{
	int64_t step; // step before which it goes off
	scree_blast_def def;
} SceneBlast;

typedef struct // rays of each body of a block
{
	int block;          // position in Scene.blocks of the bodies that cast; -1: the world
	int count;          // rays per body
	scree_vec position; // m: position of the eye in the body's frame
	float angle;        // rad: middle of the fan, in the body's frame
	float spread;       // rad: angle from the first ray to the last; at FULL_TURN the last ray is next to the first
	float length;       // m
	float radius;       // m: radius of the circle that moves along each ray
	scree_query_def def;
} Fan;

typedef struct // a force while the user holds a key
{
	SceneKey key;
	int block;        // position in Scene.blocks
	int first, count; // bodies of the block
	scree_vec force;  // N, at the center of mass, in each step that begins with the key down
	float torque;     // N m
	bool turns;       // true if the force rotates with the body
} Control;

typedef struct // a mover, the body that shows it, and its script
{
	int block; // position in Scene.blocks of its body, the first one of a kinematic entry
	int takes; // position in Scene.blocks of the bodies with sensors that it takes when it enters them; -1: none
	scree_mover_def def;
	float speed; // m/s: walking speed
	float jump;  // m/s: upward speed at the start of a jump
	Cue* cues;   // in ascending order of the steps
	int cue_count;
} Character;

typedef struct
{
	char name[64];
	char title[160];
	scree_world_def world; // the caller sets device, threads and lanes
	float dt;              // s
	int substeps;
	int steps;               // steps of a run, unless the user selects another number
	float penetration_limit; // m: a run with deeper overlaps is invalid
	bool has_view;
	scree_box view; // m: view of a picture
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
	Block* blocks; // blocks of bodies, then of collidables without a body
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
