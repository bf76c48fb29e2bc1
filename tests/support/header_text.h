// SPDX-License-Identifier: MIT
// header_text.h -- reads the public header as text, for tests that compare lists with it.
#ifndef HEADER_TEXT_H
#define HEADER_TEXT_H

// Returns the text of scree.h, which the caller frees.
char* read_header(void);

#endif
