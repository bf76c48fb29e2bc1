// SPDX-License-Identifier: MIT
// option_values.h -- options that several programs have, and the readers of their values.
#ifndef OPTION_VALUES_H
#define OPTION_VALUES_H
#include "options.h"
#include <stddef.h>

extern const Option option_steps, option_threads, option_lanes, option_allow_unequal_bits, option_set;
extern const Option option_picture, option_video, option_size, option_view, option_zoom, option_csv;
extern const Option option_known, option_help;

// functions for Option.read
bool read_switch(Options* options, const Option* option, char* text);
bool read_text(Options* options, const Option* option, char* text);
bool read_number(Options* options, const Option* option, char* text);

// the last members of an Option that sets a member of Options, or of a struct that begins with them
#define SWITCH(type, member)       read_switch, offsetof(type, member), 0
#define TEXT(type, member)         read_text, offsetof(type, member), 0
#define NUMBER(type, member, most) read_number, offsetof(type, member), most
#define OTHER(read)                read, 0, 0 // the function sets the value

#endif
