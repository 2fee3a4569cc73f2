"""The FT232H, and each port of an FT2232H, in FT245 mode or as a UART, by two drivers over one chip.

- `kinds`: what sets the two chips apart
- `chip`: found, checked and configured through pyftdi, for both drivers
- `with_pyftdi`: ``ftdi:``, transfers by pyftdi in two threads
- `with_libusb`: ``ftdi-async:``, overlapped transfers by libusb1 in the event loop
- `transport`, `inbox`: what both have in common towards the event loop
- `eeprom`, `eeprom_image`: what the pins are after the next plug-in
"""
