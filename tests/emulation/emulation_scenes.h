// SPDX-License-Identifier: MIT
// emulation_scenes.h -- small worlds that have in them what a solve must treat.
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

// Steps two worlds of a scene, of which one is solved by a form. Fails at the first step after which the hashes differ, and
// says by which seed.
void check_form(const FormScene* scene, const Form* form);

// Solves a scene by a form whose turns stop somewhere. Fails unless all work-items end, and the device says so.
void check_fault(const char* scene, Form form);

// The same with one word that is lost, for some words of a launch and for each of its last ones.
void check_lost(const char* scene, Form form);

// Returns the number of seeds with which a form is tried on a scene: SCREE_SEEDS of the environment, else few; in quick builds one
// on every third scene.
int form_seeds(int form, int scene);

// Exit status of a test that cannot emulate here and says why, else 0.
int check_refused(void);

#endif
