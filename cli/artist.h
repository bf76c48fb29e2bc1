// SPDX-License-Identifier: MIT
// artist.h -- who draws the pictures of a run: Cairo, or OpenGL.
#ifndef ARTIST_H
#define ARTIST_H
#include "scene/picture.h"
#include "simulation.h"

typedef struct Artist Artist;

// Opens the one that the options ask for. Returns null and sets an exit code after printing what is wrong.
Artist* artist_open(const Options* options, int* code);
void artist_close(Artist* artist);

// What worlds must know to be drawn by it; may be null.
const scree_opengl* artist_opengl(const Artist* artist);

// Whose pictures are drawn from now on. False after printing what is wrong.
bool artist_world(Artist* artist, Simulation* simulation);

// Draws the simulation as it is now.
scree_status artist_draw(Artist* artist, Simulation* simulation, const char* caption);

// What it draws on.
Canvas* artist_canvas(Artist* artist);

#endif
