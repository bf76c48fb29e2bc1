// SPDX-License-Identifier: MIT
// stiffness.h -- scree_peers stiffness: measures how far joints give way in both engines.
#ifndef STIFFNESS_H
#define STIFFNESS_H

// Reads the words after "stiffness" and prints a table. Returns an exit code.
int stiffness_peers(int count, char** words, const char* executable);

#endif
