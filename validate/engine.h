// SPDX-License-Identifier: MIT
// engine.h -- declares the functions of a physics engine for experiments, trials and benchmarks.
#ifndef ENGINE_H
#define ENGINE_H
#include "scree/scree.h"

typedef struct
{
	const char* device; // device of Scree as in scree_world_def
	int threads, lanes; // 0: the engine chooses
	bool allow_unequal_bits;
	bool continuous; // true: continuous collision in Box2D; Scree always has continuous collision
	bool sleep;      // true: bodies at rest fall asleep
} EngineOptions;

typedef struct
{
	// definition of Scree's world; device, threads, lanes and sleep come from EngineOptions, and other engines use
	// only gravity
	scree_world_def world;
	float max_speed;     // m/s; 0: world.max_speed in Scree, the engine's default in others
	float contact_hertz; // stiffness of contacts, Hz; 0: world.contact_hertz in Scree, the engine's default in others
} EngineDef;

typedef struct // a collidable of a body
{
	scree_attribute_def surface; // shape and surface in the frame of the body
	scree_filter filter;
} EnginePart;

typedef struct
{
	int index; // index by which other functions refer to the body; the caller chooses small indices
	scree_body_def def;
	EnginePart* parts;
	int count;
	bool bullet; // true: the body is a bullet, in engines that have bullets
} EngineBody;

#define ENGINE_WORLD -1 // value of EngineJoint.a or b that means the world

typedef struct
{
	scree_joint_def def; // definition without body_a and body_b
	int a, b;            // indices of bodies a and b, or ENGINE_WORLD
} EngineJoint;

typedef struct // functions that return bool print a message and return false on failure
{
	const char* name;
	void* (*open)(const EngineOptions* options, const EngineDef* def); // returns the state of a world; null on failure
	bool (*create)(void* state, const EngineBody* bodies, int count);
	bool (*destroy)(void* state, const int* bodies, int count); // afterwards the indices may be used again
	// adds a joint; only the types of Box2D 3 are possible, because all engines have these
	bool (*join)(void* state, const EngineJoint* joint);
	bool (*set_poses)(void* state, const int* bodies, const scree_pose* poses, int count);
	bool (*set_velocity)(void* state, int body, scree_velocity velocity);
	bool (*push)(void* state, int body, scree_vec force); // adds a force, N, for the next step
	bool (*step)(void* state, float dt, int substeps);
	bool (*wait)(void* state);                // waits until all work is done
	bool (*frozen)(void* state, int* frozen); // adds to *frozen the number of bodies that the last step froze
	bool (*awake)(void* state, int* awake);   // sets *awake to the number of dynamic bodies that are awake
	// reads poses and velocities of bodies, or of indices 0 to count - 1 if `bodies` is null; `velocities` may be null
	bool (*read)(void* state, const int* bodies, int count, scree_pose* poses, scree_velocity* velocities);
	bool (*hash)(void* state, uint64_t* hash); // hash of all simulated state, as the engine defines it
	double (*bytes)(void* state);              // memory of the world, bytes
	scree_world* (*world)(void* state);        // Scree's world; the pointer is null for other engines
	void (*close)(void* state);
} Engine;

#endif
