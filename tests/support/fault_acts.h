// SPDX-License-Identifier: MIT
// fault_acts.h -- declares a program of many public calls, for tests in which one call fails.
#ifndef FAULT_ACTS_H
#define FAULT_ACTS_H
#include "support/checks.h"

#define BODIES 300 // more bodies than a new world has room for
#define FREE   20
#define LINKS  12 // enough joints in a row for a chain

typedef struct
{
	scree_world* world;
	const char* device;    // device of the world; null: the CPU
	float device_timeout;  // s, as in scree_world_def
	int recovery_interval; // the same
	scree_attribute box, circle, slab;
	scree_body bodies[BODIES];
	scree_body slab_body;
	scree_collidable free[FREE], sensor;
	scree_body links[LINKS];
	scree_joint joints[LINKS + 4];
	int joint_count;
	scree_path path;
	scree_field field;
	void* saved; // snapshot, released by fault_run_end
	size_t saved_size;
	bool timings;
} FaultRun;

// Makes one or more public calls. If one fails, the act returns its status, and may be repeated.
typedef scree_status (*Act)(FaultRun* s);

typedef struct
{
	const char* name;
	Act act;
	bool several, opens; // as in fault_acts.def
} FaultAct;

#define ACT(name, several, opens) scree_status name(FaultRun* s);
#include "support/fault_acts.def"
#undef ACT

enum
{
	FAULT_ACTS = 0
#define ACT(name, several, opens) +1
#include "support/fault_acts.def"
#undef ACT
};
extern const FaultAct fault_acts[FAULT_ACTS];

// Checks that calls on a broken world return the status of the fault, and that their messages contain "the world can
// only be destroyed".
void check_broken(FaultRun* s, scree_status status);

// Destroys the world of a run, and releases its snapshot.
void fault_run_end(FaultRun* s);

#endif
