// SPDX-License-Identifier: Apache-2.0
// The light controller's program: ATmega328P at 16 MHz, on an Arduino Uno or Nano. docs/light-controller.md.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <avr/wdt.h>
#include <util/atomic.h>

#include "config.h"
#include "controller.h"
#include "lights.h"
#include "uart.h"

// Not cleared at the start: other than at the start before.
static uint16_t seed __attribute__((section(".noinit")));
static uint8_t reset_flags __attribute__((section(".noinit")));

static volatile uint32_t milliseconds;

// Runs before everything else. After a watchdog's reset the watchdog is still on at its shortest time, and
// the clearing of memory must not take longer; it is set to what the main loop keeps up with, and never
// stopped.
void keep_reset_flags(void) __attribute__((naked, used, section(".init3")));
void keep_reset_flags(void) {
  reset_flags = MCUSR;
  MCUSR = 0;
  wdt_enable(WDTO_120MS);
}

// A power-on sets the brown-out's flag too, so the order matters. No flag: a boot loader has read them away.
static char reset_cause(void) {
  if (reset_flags & (1u << PORF)) return 'P';
  if (reset_flags & (1u << BORF)) return 'B';
  if (reset_flags & (1u << WDRF)) return 'W';
  if (reset_flags & (1u << EXTRF)) return 'E';
  return 'U';
}

ISR(TIMER0_COMPA_vect) { ++milliseconds; }

static void clock_begin(void) {
  TCCR0A = 1u << WGM01;
  TCCR0B = 1u << CS01 | 1u << CS00;  // 16 MHz / 64
  OCR0A = F_CPU / 64 / 1000 - 1;
  TIMSK0 = 1u << OCIE0A;
}

static uint32_t now_ms(void) {
  uint32_t now = 0;
  ATOMIC_BLOCK(ATOMIC_RESTORESTATE) { now = milliseconds; }
  return now;
}

// Lit while a light is on; a short flash each second says that the controller waits.
static uint8_t status_at(uint32_t now, uint16_t on) { return on != 0 || (now & 1023u) < 32u; }

int main(void) {
  static struct controller controller;
  static char reply[LINE_CAPACITY + 1];

  const uint16_t wired = lights_begin();
  uart_begin();
  clock_begin();
  controller_begin(&controller, wired, DORSUM_INVERTED ? 'I' : 'N', reset_cause(), ++seed);
  set_sleep_mode(SLEEP_MODE_IDLE);
  sei();
  uart_write(reply, controller_banner(&controller, reply));

  for (;;) {
    wdt_reset();
    const uint32_t now = now_ms();
    char byte = 0;
    bool damaged = false;
    while (uart_read(&byte, &damaged)) {
      const uint8_t length = controller_byte(&controller, byte, damaged, now, reply);
      // A light changes before its change is reported.
      lights_show(controller.on);
      if (length > 0) uart_write(reply, length);
    }
    controller_tick(&controller, now);
    lights_show(controller.on);
    lights_status(status_at(now, controller.on));
    sleep_mode();  // until the next byte or millisecond
  }
}
