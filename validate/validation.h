// SPDX-License-Identifier: MIT
// validation.h -- a validation, and the lab of its experiment.
//
// A lab is a world in which an experiment is made, by Scree or by another engine. It keeps the definitions of its bodies, so
// that an engine only creates, steps and reads them. The first failure is printed and sets Validation.broken. From then on
// the functions of lab.h do nothing, so that experiments need not check for errors.
#ifndef VALIDATION_H
#define VALIDATION_H
#include "engine.h"
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
	bool bullets;        // thrown bodies have the flag of continuous collision, in engines that have one
	float contact_hertz; // stiffness of contacts; 0 is the engine's own
} LabDef;

typedef struct
{
	float mass;       // kg; 0 unless the body is dynamic
	float inertia;    // kg m^2 about the center
	scree_vec center; // center of mass, in the body's frame
} LabMass;

struct Lab
{
	Validation* validation;
	LabDef def;
	void* state;
	EngineBody* bodies; // by their index
	LabMass* masses;    // masses of the bodies
	scree_pose* poses;  // lab_read writes them
	scree_velocity* velocities;
	EngineJoint* joints;
	int count, capacity, created;
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
	const Engine* engine;
	EngineOptions options;
	const char* executable; // scenes may lie beside it; may be null
	bool quick;             // fewer and shorter runs, for tests
	FILE* out;

	Lab* lab;               // the open one, or null
	const char* experiment; // name
	char text[96];          // name of the case
	char where[128];        // the run that gave the value; may be empty
	int64_t steps;          // since the case began
	uint64_t hash;          // hash of the end states of the labs that the case has closed
	int failures;           // rows beyond their limits
	bool broken;            // an engine or memory failed
};

#endif
