// SPDX-License-Identifier: MIT
// mass.h -- the mass of a body, computed from its collidables.
#ifndef MASS_H
#define MASS_H
#include "world/world.h"

// Returns the mass that the user set, else the sum over the collidables, else 1 kg that cannot turn; 0 if not dynamic.
scree_mass mass_of_body(const scree_world* world, int body);

// Returns HostBody.mass with its inertia, even if the inertia is not yet stored there.
scree_mass mass_now(const scree_world* world, int body);

// Return inverse mass, 1/kg, and inverse inertia, 1/(kg m^2), 0 for locked rotation. The inverse of 0 is 0.
float mass_inverse(const HostBody* host);
float mass_inverse_inertia(const HostBody* host);

// Return the row in pool continuous_body, and its command. May lower Pipeline.continuous_way, raise continuous_reach.
ContinuousBody continuous_row(scree_world* world, int body);
Command continuous_command(scree_world* world, int body);

// Records an anchor of a joint, in the body's frame. The caller has reserved memory for a command.
void mass_anchor(scree_world* world, int body, scree_vec anchor);

// Updates the mass after a collidable became a sensor or solid; body -1: none. Memory for a command is reserved.
void mass_touches(scree_world* world, int body);

// Sets the mass of a body on the host and on the device. The caller has reserved memory for two commands.
void mass_set(scree_world* world, int body, scree_mass mass);

// Does the same for a mass set by the user, which is kept while the type is another, until its collidables change.
void mass_own(scree_world* world, int body, scree_mass mass);

// Recomputes the mass of each dynamic body in the list, once each, and sends the ContinuousBody of others; -1: no body.
// gained: bodies only got collidables, so the next mass_settle computes the inertia, with a command for which
// edits_reserve leaves memory. Otherwise creating n collidables one by one would sum up n^2 / 2 of them.
void masses_update(scree_world* world, const int* bodies, int count, bool gained);

// Computes the pending inertia. Called before uploads, reads of it, and commands that depend on it.
void mass_settle(scree_world* world);

// Drops the sums for a body, because its mass is set in another way or it is about to be destroyed.
void mass_forget(scree_world* world, int body);

#endif
