// The sensors of a hand on an Arduino Mega 2560: 45 analog touch sensors at three multiplexers
// CD74HC4067, and up to 11 potentiometers at the joints. It sends sensor frames
// (docs/formats/sensor-frames.md): first the touch sensors, multiplexer by multiplexer, then the
// potentiometers, each as read by the 10-bit converter, 0 to 1023.
//
// Wiring:
//   D22, D23, D24, D25   S0, S1, S2, S3 of all three multiplexers
//   A0, A1, A2           SIG of the multiplexers; EN of each to GND
//   A3 to A13            the potentiometers' sliders, between 5 V and GND
// Inputs C15 of the multiplexers stay free. Each touch sensor forms a voltage divider with a
// resistor to GND at its input.

#include "sensor_frame_writer.h"

const int kPotentiometers = 11;  // 0 to 11; the device file states the same number.
const int kMultiplexers = 3;
const int kInputs = 15;  // Used inputs of each multiplexer.
const int kTouch = kMultiplexers * kInputs;
const uint32_t kPeriod = 20000;  // Microseconds between frames: 50 a second.
const unsigned long kBaud = 115200;

const uint8_t kSelect[4] = {22, 23, 24, 25};
const uint8_t kSignal[kMultiplexers] = {A0, A1, A2};
const uint8_t kPotentiometer[] = {A3, A4, A5, A6, A7, A8, A9, A10, A11, A12, A13};

SensorFrameWriter<kTouch + kPotentiometers> writer;
int16_t touch[kTouch];
uint16_t sequence = 0;
uint32_t due = 0;

// Begins anew after 71 minutes.
uint32_t now() { return static_cast<uint32_t>(micros()); }

void setup() {
  for (int i = 0; i < 4; ++i) pinMode(kSelect[i], OUTPUT);
  Serial.begin(kBaud);
  due = now();
}

void select_input(int input) {
  for (int i = 0; i < 4; ++i) digitalWrite(kSelect[i], ((input >> i) & 1) ? HIGH : LOW);
  delayMicroseconds(5);  // The converter's input settles.
}

// The inputs are selected for all multiplexers at once, so the loops are in this order. The first
// reading after another pin is discarded: it contains some of that pin's charge.
void read_touch() {
  for (int input = 0; input < kInputs; ++input) {
    select_input(input);
    for (int i = 0; i < kMultiplexers; ++i) {
      analogRead(kSignal[i]);
      touch[i * kInputs + input] = static_cast<int16_t>(analogRead(kSignal[i]));
    }
  }
}

void write_byte(uint8_t byte) { Serial.write(byte); }

void loop() {
  if (now() - due >= 0x80000000UL) return;  // Not yet due.
  due += kPeriod;
  writer.begin(sequence++, now());
  read_touch();
  for (int i = 0; i < kTouch; ++i) writer.add(touch[i]);
  for (int i = 0; i < kPotentiometers; ++i) {
    analogRead(kPotentiometer[i]);
    writer.add(static_cast<int16_t>(analogRead(kPotentiometer[i])));
  }
  writer.send(write_byte);
}
