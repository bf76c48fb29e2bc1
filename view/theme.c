// SPDX-License-Identifier: MIT
// theme.c -- defines all colors except those of dynamic bodies, for a light or a dark background.
#include "view/theme.h"

static const Theme themes[] = {
    {BACKGROUND_COLOR, TEXT_COLOR, {196, 192, 184}, {67, 93, 134}, {23, 89, 77}, {58, 54, 50}, {28, 32, 40}},
    {{27, 29, 33},
     {214, 212, 206},
     {104, 107, 114},
     {132, 164, 212},
     {176, 232, 206},
     {204, 198, 188},
     {245, 243, 236}}};

const Theme* theme_of(bool dark) { return &themes[dark]; }
