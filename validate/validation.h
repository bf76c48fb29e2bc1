// SPDX-License-Identifier: MIT
// validation.h -- a validation, the lab of its experiment, and what an engine must do.
//
// A lab is a world in which an experiment is made, by Scree or by another engine. It keeps the definitions of its bodies, so
// that an engine only creates, steps and reads them. The first failure is printed and sets Validation.broken. From then on
// the functions of lab.h do nothing, so that experiments need not check for errors.
#ifndef VALIDATION_H
#define VALIDATION_H
#include "scree/scree.h"
#include <stdio.h>

#define LAB_DT       (1.0f / 60.0f) // s
#define LAB_SUBSTEPS 4

typedef struct Lab Lab;
typedef struct Validation Validation;

typedef struct
{
	scree_vec gravity; // m/s^2
	float dt;          // s
	int substeps;
	float max_speed;     // m/s
	bool bullets;        // where an engine has such a flag, bodies that are thrown have it
	float contact_hertz; // stiffness of contacts; 0 is the engine's own
} LabDef;

typedef struct // a collidable of a body
{
	scree_attribute_def surface; // in the body's frame
	scree_filter filter;
} LabPart;

typedef struct
{
	scree_body_def def;
	int first, count; // indices in Lab.parts
	float mass;       // kg; 0 unless the body is dynamic
	float inertia;    // kg m^2 about the center
	scree_vec center; // of mass, in the body's frame
	bool thrown;      // by lab_throw
} LabBody;

typedef struct
{
	scree_joint_def def; // without its bodies
	int a, b;            // bodies
} LabJoint;

typedef struct
{
	const char* device; // as in scree_world_def
	int threads, lanes;
	bool allow_unequal_bits;
} LabOptions;

// The functions of an engine. They return false after printing a sentence. Bodies are indices in Lab.bodies.
typedef struct
{
	const char* name;
	void* (*open)(const LabOptions* options, const LabDef* def); // null on failure
	bool (*create)(void* state, const Lab* lab, int first, int count);
	bool (*join)(void* state, const LabJoint* joint); // of types that all engines have: of Box2D 3
	// destroys these bodies and creates them again as the lab defines them now; nothing else changes
	bool (*replace)(void* state, const Lab* lab, const int* bodies, int count);
	bool (*set_poses)(void* state, const int* bodies, const scree_pose* poses, int count);
	bool (*set_velocity)(void* state, int body, scree_velocity velocity);
	bool (*push)(void* state, int body, scree_vec force);                     // a force in the next step, N
	bool (*step)(void* state, float dt, int substeps, int* frozen);           // adds the number of bodies that it froze
	bool (*read)(void* state, scree_pose* poses, scree_velocity* velocities); // of all bodies
	bool (*wait)(void* state);                                                // until all work is done
	bool (*hash)(void* state, uint64_t* hash);                                // of all simulated state
	double (*bytes)(void* state);                                             // of memory that the world holds
	void (*close)(void* state);
} LabEngine;

struct Lab
{
	Validation* validation;
	LabDef def;
	void* state;
	LabBody* bodies;
	LabPart* parts;
	scree_pose* poses; // of all bodies; lab_read writes them
	scree_velocity* velocities;
	LabJoint* joints;
	int count, capacity, created, part_count, part_capacity;
	int joint_count, joint_capacity, joined;
	int frozen; // bodies that the engine froze, in all steps
};

typedef enum
{
	SHOWN,   // no limit
	AT_MOST, // fails for values that are not numbers, too
	AT_LEAST,
} Limit;

struct Validation
{
	const LabEngine* engine;
	LabOptions options;
	const char* executable; // scenes may lie beside it; may be null
	bool quick;             // fewer and shorter runs, for tests
	FILE* out;

	Lab* lab;               // the open one, or null
	const char* experiment; // name
	char text[96];          // of the case
	char where[128];        // the run that gave the value; may be empty
	int64_t steps;          // since the case began
	uint64_t hash;          // of the end states of the labs that the case has closed
	int failures;           // rows beyond their limits
	bool broken;            // an engine or memory failed
};

#endif
