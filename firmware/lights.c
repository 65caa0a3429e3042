// SPDX-License-Identifier: Apache-2.0
#include "lights.h"

#include <avr/io.h>
#include <avr/wdt.h>
#include <util/delay.h>

#include "config.h"

#define PORT_D_LIGHTS 0xFCu  // D2 to D7: channels 0 to 5
#define PORT_B_LIGHTS 0x07u  // D8 to D10: channels 6 to 8
#define PORT_B_STATUS (1u << PB5)

static uint8_t driven_d, driven_b;  // the pins that are outputs

static uint8_t of_port_d(uint16_t channels) { return (uint8_t)(channels << 2) & PORT_D_LIGHTS; }
static uint8_t of_port_b(uint16_t channels) { return (uint8_t)(channels >> 6) & PORT_B_LIGHTS; }

uint16_t lights_begin(void) {
  const uint8_t off_level = DORSUM_INVERTED ? 0xFFu : 0x00u;
  uint8_t right_d = PORT_D_LIGHTS, right_b = PORT_B_LIGHTS;
  for (uint8_t i = 0; i < 16; ++i) {  // longer than a period of mains hum
    right_d &= (uint8_t) ~(PIND ^ off_level);
    right_b &= (uint8_t) ~(PINB ^ off_level);
    wdt_reset();
    _delay_us(1300);
  }
  driven_d = right_d;
  driven_b = right_b;
  lights_show(0);
  return (uint16_t)(driven_d >> 2 | (uint16_t)driven_b << 6);
}

static uint8_t level_d(uint16_t on) {
  return (uint8_t)(of_port_d(on) ^ (DORSUM_INVERTED ? 0xFFu : 0x00u)) & driven_d;
}
static uint8_t level_b(uint16_t on) {
  return (uint8_t)(((uint8_t)(of_port_b(on) ^ (DORSUM_INVERTED ? 0xFFu : 0x00u)) & driven_b) |
                   (PORTB & PORT_B_STATUS));
}

void lights_show(uint16_t on) {
  static uint16_t shown;
  // First out what goes out, then on what comes on: the two ports change one after the other, and no two
  // lasers may shine together for even that long.
  const uint16_t kept = shown & on;
  PORTD = level_d(kept);
  PORTB = level_b(kept);
  // The level before the direction: a pin that becomes an output before it has its level could flash.
  PORTD = level_d(on);
  PORTB = level_b(on);
  DDRD = driven_d;
  DDRB = (uint8_t)(driven_b | PORT_B_STATUS);
  shown = on;
}

void lights_status(uint8_t lit) {
  if (lit) {
    PORTB |= PORT_B_STATUS;
  } else {
    PORTB &= (uint8_t)~PORT_B_STATUS;
  }
}
