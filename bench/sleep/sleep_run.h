// SPDX-License-Identifier: MIT
// sleep_run.h -- defines a case of scree_sleep and one run of it: a world, its steps, and the state that they lead to.
#ifndef SLEEP_RUN_H
#define SLEEP_RUN_H
#include "validate/engine.h"

#define SPAWNED 32 // number of bodies that the case `spawn` keeps alive

typedef struct // the command line
{
	EngineOptions place; // device, threads and lanes
	int sleepers;        // number of sleeping bodies; 0: that of the case
	int awake;           // number of awake bodies; 0: 1 % of all bodies
	int rows;            // rows of the pyramid of the cases that wake one
	int steps;           // steps that are timed, in cases that wake nothing
	int repeats;         // timed runs of each world
} SleepSetting;

typedef enum // the awake bodies of a world
{
	NO_BODY,
	ONE_BALL,
	SOME_BALLS,
	SOME_PYRAMIDS,
} AwakeBodies;

typedef enum // the time with which the time of a step is compared
{
	BESIDE_NOTHING,
	BESIDE_AWAKE,    // a step of a world that contains only the awake bodies, at the same places
	BESIDE_NO_SLEEP, // a step of the same world without sleep
	BESIDE_LATER,    // later steps of the same run; the first steps wake bodies
} Beside;

typedef struct SleepRun SleepRun;

typedef struct
{
	const char *name, *about;
	Beside beside;
	AwakeBodies awake;
	int sleepers;                           // default number of sleeping bodies
	bool large;                             // true: the case runs only if it is named
	bool created_asleep;                    // in cases that wake a pyramid: it is created asleep
	bool (*build)(SleepRun* run);           // fills the world; returns false after printing a message
	bool (*act)(SleepRun* run, int number); // calls of a user before a step, or null; number: from 0
} SleepCase;

struct SleepRun
{
	const SleepCase* item;
	const SleepSetting* setting;
	bool compared; // true: the world with which that of the case is compared
	bool checked;  // true: counters are read after each step, so the steps are not timed
	scree_world* world;
	scree_attribute box;         // attribute of all boxes
	scree_body spawned[SPAWNED]; // bodies of the case `spawn`
	scree_body hit, woken;       // top of the pyramid, and a body in its lowest row
	scree_collidable sensor;
	int asleep;          // expected number of sleeping bodies at the end
	int found, expected; // hits of rays or visits of the sensor, and their correct number
	float penetration;   // deepest overlap of all steps, m; only if `checked`
	int frozen;          // bodies that were frozen, in all steps; only if `checked`
};

// Takes a step of 1/60 s with 4 substeps, and reads the counters if the run is checked. Returns false after printing a
// message.
bool sleep_run_step(SleepRun* run);

#endif
