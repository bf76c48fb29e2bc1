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
	bool hubs; // has bodies with many contacts
	void (*build)(scree_world* world);
	void (*act)(scree_world* world, int step); // before each step; may be null
} FormScene;

extern const FormScene form_scenes[];
extern const int form_scene_count;
const FormScene* form_scene(const char* name);

// Steps two worlds of a scene, one of them with solves by a form. Fails at the first step after which the hashes
// differ, and prints the seed.
void check_form(const FormScene* scene, const Form* form);

// Solves a scene by a form in which a work-item stops. Fails unless all work-items end and the device reports a
// timeout.
void check_fault(const char* scene, Form form);

// Calls check_fault with one lost word, for some words of a launch and for each of its last words.
void check_lost(const char* scene, Form form);

// Returns the number of seeds to try for a form on a scene: SCREE_SEEDS of the environment, else 2; in quick builds one
// seed on every third scene.
int form_seeds(int form, int scene);

// Returns 77 and prints the reason if work-items cannot be emulated here, else returns 0.
int check_refused(void);

#endif
