// SPDX-License-Identifier: Apache-2.0
#ifndef DORSUM_FIRMWARE_UART_H
#define DORSUM_FIRMWARE_UART_H

#include <stdbool.h>
#include <stdint.h>

// The serial line, 8N1 at BAUD, through two ring buffers that interrupts fill and empty.

void uart_begin(void);
// Takes a received byte; `damaged` when the receiver saw a framing error with it or lost bytes before it.
bool uart_read(char* byte, bool* damaged);
// All of it or nothing: half a line helps nobody.
void uart_write(const char* bytes, uint8_t length);

#endif
