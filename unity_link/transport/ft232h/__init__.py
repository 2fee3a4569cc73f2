"""Two drivers for an FT232H, or a port of an FT2232H, in FT245 mode or as a UART.

- `kinds`: the differences between the two chips
- `chip`: finds, checks and configures a chip by pyftdi, for both drivers
- `with_pyftdi`: ``ftdi:``, transfers by pyftdi in two threads
- `with_libusb`: ``ftdi-async:``, overlapped transfers by libusb1 in the event loop
- `transport`: the common base class of both transports
- `eeprom`, `eeprom_image`: the EEPROM, which sets the mode of the pins
"""
