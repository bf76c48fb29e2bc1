// SPDX-License-Identifier: MIT
// arguments.h -- macros for the arguments of calls: recorded_calls.def, reading_calls.def and plain_calls.def have them as (kind, type, name).
#ifndef ARGUMENTS_H
#define ARGUMENTS_H

#define MOST_RECORDED_ARGUMENTS 4 // maximum number of arguments of a recorded call, the world not counted

// Applies a macro to the number and to each of one to eight arguments, with commas between the results.
#define EACH_1(f, a)                                         f(0, a)
#define EACH_2(f, a, b)                                      EACH_1(f, a), f(1, b)
#define EACH_3(f, a, b, c)                                   EACH_2(f, a, b), f(2, c)
#define EACH_4(f, a, b, c, d)                                EACH_3(f, a, b, c), f(3, d)
#define EACH_5(f, a, b, c, d, e)                             EACH_4(f, a, b, c, d), f(4, e)
#define EACH_6(f, a, b, c, d, e, g)                          EACH_5(f, a, b, c, d, e), f(5, g)
#define EACH_7(f, a, b, c, d, e, g, h)                       EACH_6(f, a, b, c, d, e, g), f(6, h)
#define EACH_8(f, a, b, c, d, e, g, h, i)                    EACH_7(f, a, b, c, d, e, g, h), f(7, i)
#define EACH_EIGHTH_AFTER(a, b, c, d, e, g, h, i, each, ...) each
#define EACH_OF(...)                                         EACH_EIGHTH_AFTER(__VA_ARGS__, EACH_8, EACH_7, EACH_6, EACH_5, EACH_4, EACH_3, EACH_2, EACH_1, 0)
#define EACH(f, ...)                                         EACH_OF(__VA_ARGS__)(f, __VA_ARGS__)

// type of an argument in C, by its kind
#define VALUE_TYPE(type)   type
#define COUNT_TYPE(type)   type
#define SIZE_TYPE(type)    type
#define POINTER_TYPE(type) const type*
#define ARRAY_TYPE(type)   const type*
#define PATH_TYPE(type)    const type*
#define BYTES_TYPE(type)   const type*
#define RESULT_TYPE(type)  type*
#define RESULTS_TYPE(type) type*

// declaration of an argument, for EACH
#define PARAMETER_OF(kind, type, name) kind##_TYPE(type) name
#define AS_PARAMETER(k, argument)      PARAMETER_OF argument

// name and address of an argument, for EACH
#define NAME_OF(kind, type, name)    name
#define ADDRESS_OF(kind, type, name) &name
#define AS_NAME(k, argument)         NAME_OF argument
#define AS_ADDRESS(k, argument)      ADDRESS_OF argument

#endif
