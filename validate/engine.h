// SPDX-License-Identifier: MIT
// engine.h -- the functions of a physics engine, for experiments, trials and benchmarks.
#ifndef ENGINE_H
#define ENGINE_H
#include "scree/scree.h"

typedef struct
{
	const char* device; // device of Scree, as in scree_world_def
	int threads, lanes; // 0: the engine's own choice
	bool allow_unequal_bits;
	bool continuous; // continuous collision of Box2D; Scree always has it
} EngineOptions;

typedef struct
{
	scree_world_def world; // world of Scree, without device, threads and lanes; other engines take its gravity
	float max_speed;       // m/s; 0: that of world, or the other engine's own
	float contact_hertz;   // stiffness of contacts; 0: the same
} EngineDef;

typedef struct // a collidable of a body
{
	scree_attribute_def surface; // in the body's frame
	scree_filter filter;
} EnginePart;

typedef struct
{
	int index; // names the body in the other functions; the caller chooses small ones
	scree_body_def def;
	EnginePart* parts;
	int count;
	bool bullet; // flag of the body, in engines that have one
} EngineBody;

#define ENGINE_WORLD -1 // as the body of a joint: the world

typedef struct
{
	scree_joint_def def; // without its bodies
	int a, b;            // indices of bodies
} EngineJoint;

typedef struct // functions return false after printing a sentence
{
	const char* name;
	void* (*open)(const EngineOptions* options, const EngineDef* def); // null on failure
	bool (*create)(void* state, const EngineBody* bodies, int count);
	bool (*destroy)(void* state, const int* bodies, int count); // their indices are free then
	bool (*join)(void* state, const EngineJoint* joint);        // types that all engines have: those of Box2D 3
	bool (*set_poses)(void* state, const int* bodies, const scree_pose* poses, int count);
	bool (*set_velocity)(void* state, int body, scree_velocity velocity);
	bool (*push)(void* state, int body, scree_vec force); // a force in the next step, N
	bool (*step)(void* state, float dt, int substeps);
	bool (*wait)(void* state);                // until all work is done
	bool (*frozen)(void* state, int* frozen); // adds the number of bodies that the last step froze
	// reads count bodies; bodies null: those from 0 on; velocities may be null
	bool (*read)(void* state, const int* bodies, int count, scree_pose* poses, scree_velocity* velocities);
	bool (*hash)(void* state, uint64_t* hash); // hash of all simulated state, by the engine
	double (*bytes)(void* state);              // memory that the world holds, bytes
	scree_world* (*world)(void* state);        // the world of Scree; the function is null for other engines
	void (*close)(void* state);
} Engine;

#endif
