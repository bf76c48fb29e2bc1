// SPDX-License-Identifier: MIT
// scene.h -- the contents of a scene file in memory. scenes/scene.schema.json describes the format of the file.
#ifndef SCENE_H
#define SCENE_H
#include "platform/exact_floats.h"
#include "scene/scene_keys.h"
#include "scree/scree.h"
#include "scree/scree_scene.h"
#include <stdio.h>

#define SCENE_MAX_BODIES 16777216 // maximum number of bodies of a world; likewise of collidables, and of joints
#define SCENE_MAX_RAYS   20000000 // maximum number of rays after a step; a ray needs 64 bytes
#define SCENE_SENTENCE   512      // size of an error message, characters
#define SCENE_PATH       1024     // size of a path, characters
#define MAX_HULL_POINTS  64
#define FULL_TURN        6.283185307f // rad

typedef struct Block Block;                   // defined in scene/block.h
typedef struct JointBlock JointBlock;         // defined in scene/joint_block.h
typedef struct Attribute Attribute;           // defined in scene/attribute_block.h
typedef struct ScenePath ScenePath;           // defined in scene/path_block.h
typedef struct SceneMaterials SceneMaterials; // defined in scene/material_block.h
typedef struct SceneExclusion SceneExclusion; // defined in scene/exclusion_block.h
typedef struct SceneNames SceneNames;         // defined in scene/names.h
typedef struct SceneField SceneField;         // defined in scene/field_block.h
typedef struct Cue Cue;                       // defined in scene/character.h

typedef struct // changes to bodies of a block before every step
{
	int moved, replaced; // bodies per step: moved to another place; replaced by new bodies at another place
	scree_pose pose;     // new pose; numbers that differ between bodies are computed later
	scree_velocity velocity;
	scree_body_def* items; // definitions of all bodies of the block at the start; their attributes are positions in
	                       // Scene.attributes
} Churn;

typedef struct // explosion
{
	int64_t step; // number of the step before which the explosion happens
	scree_blast_def def;
} SceneBlast;

typedef struct // rays that each body of a block casts
{
	int block;          // position in Scene.blocks of the bodies that cast the rays; -1: the world
	int count;          // number of rays per body
	scree_vec position; // m: origin of the rays in the body's frame
	float angle;        // rad: middle of the fan, in the body's frame
	float spread;       // rad: angle from the first to the last ray; at FULL_TURN the last ray is beside the first
	float length;       // m: length of a ray
	float radius;       // m: radius of the circle that moves along each ray
	scree_query_def def;
} Fan;

typedef struct // force on bodies while the user holds a key
{
	SceneKey key;
	int block;        // position of the bodies in Scene.blocks
	int first, count; // index in the block of the first body with the force, and number of such bodies
	scree_vec force;  // N: acts at the center of mass, in each step that begins while the key is down
	float torque;     // N m: acts in the same steps
	bool turns;       // true if the force rotates with the body
} Control;

typedef struct // mover, the body that shows it, and its script
{
	int block; // position in Scene.blocks of kinematic bodies; the first of them shows the mover
	int takes; // bodies that the character takes when it enters their sensors: position in Scene.blocks; -1: none
	scree_mover_def def;
	float speed; // m/s: walking speed
	float jump;  // m/s: upward speed at the start of a jump
	float push;  // N: maximum force with which the character pushes dynamic bodies
	Cue* cues;   // in ascending order of their steps
	int cue_count;
} Character;

typedef struct
{
	char name[SCREE_SCENE_NAME];
	char title[SCREE_SCENE_TITLE];
	scree_world_def world; // the caller sets device, threads and lanes
	float dt;              // s: length of a step
	int substeps;
	int steps;               // default number of steps of a run
	float penetration_limit; // m: a run with deeper overlaps than this is invalid
	bool has_view;
	scree_box view; // m: box of the world in pictures
	bool has_detail;
	scree_box detail; // m: box of the world that wide pictures also show, magnified
	int body_count, collidable_count, joint_count;

	uint64_t seed;
	SceneNames* names;
	Attribute* attributes;
	int attribute_count;
	ScenePath* paths;
	int path_count;
	SceneMaterials* materials;
	int material_count;
	SceneExclusion* exclusions;
	int exclusion_count;
	SceneField* fields;
	int field_count;
	SceneBlast* blasts;
	int blast_count;
	Block* blocks; // blocks of bodies, then blocks of collidables without a body
	int block_count;
	JointBlock* joint_blocks;
	int joint_block_count;
	Control* controls;
	int control_count;
	Character* characters;
	int character_count;
	Fan* fans;
	int fan_count, ray_count; // number of fans, and number of rays of all bodies after each step
} Scene;

typedef scree_scene_setting SceneSetting;

typedef enum // setting of a user that replaces the key "sleep" of a scene
{
	SLEEP_OF_SCENE, // no such setting
	SLEEP_OFF,
	SLEEP_ON,
} SceneSleep;

// Returns whether the world of a scene sleeps.
static inline bool scene_sleeps(const Scene* scene, SceneSleep sleep)
{
	return sleep == SLEEP_OF_SCENE ? scene->world.sleep : sleep == SLEEP_ON;
}

#endif
