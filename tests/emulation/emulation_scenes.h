// SPDX-License-Identifier: MIT
// emulation_scenes.h -- small worlds that contain all cases of a solve.
#ifndef EMULATION_SCENES_H
#define EMULATION_SCENES_H
#include "emulation/emulated_forms.h"
#include "support/checks.h"

typedef struct
{
	const char* name;
	int steps;
	bool hubs; // true: the scene has bodies with many contacts
	void (*build)(scree_world* world);
	void (*act)(scree_world* world, int step); // called before each step; may be null
} FormScene;

extern const FormScene form_scenes[];
extern const int form_scene_count;
const FormScene* form_scene(const char* name);

// Steps two worlds of a scene: one on the CPU, and one whose solves are executed by a form. Fails at the first step
// after which hashes or counters differ, and prints the seed.
void check_form(const FormScene* scene, const Form* form);

// Solves a scene by a form whose schedule stops a group or loses a write to a mailbox. Fails unless all work-items end
// and the device reports a timeout.
void check_fault(const char* scene, Form form);

// Calls check_fault several times, each time with one lost write to a mailbox: for some of the earlier writes of a
// launch, and for each of the last writes.
void check_lost(const char* scene, Form form);

// Returns the number of seeds to try for a form on a scene: the environment variable SCREE_SEEDS if it is set, else 2.
// In quick builds every third scene gets one seed, and other scenes none.
int form_seeds(int form, int scene);

// Prints the reason and returns 77 if work-items cannot be emulated here; otherwise returns 0.
int check_refused(void);

#endif
