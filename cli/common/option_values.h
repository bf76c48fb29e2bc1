// SPDX-License-Identifier: MIT
// option_values.h -- defines the options that several programs have, and reads the values of options.
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

// Prints that the value of an option must be or do something else, with the words `must`, and returns false.
bool refuse_value(const Options* options, const Option* option, const char* text, const char* must);

// last three members of an Option. SWITCH, TEXT and NUMBER set a member of Options, or of a struct that begins with
// Options.
#define SWITCH(type, member)       read_switch, offsetof(type, member), 0
#define TEXT(type, member)         read_text, offsetof(type, member), 0
#define NUMBER(type, member, most) read_number, offsetof(type, member), most
#define OTHER(read)                read, 0, 0 // for an option whose read function needs no offset

#endif
