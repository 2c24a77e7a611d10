"""The token and the host with which the tests ask, and a deck that runs in a moment, or for long with another stop time."""

TOKEN, HOST = "a" * 32, "127.0.0.1:8123"
LONG = '"20 ms"'
TUBE = """title = "Tube / of \\"gas\\""
stop_time = "20 us"
[[region]]
name = "left"
material = "gas"
from = "0 mm"
to = "10 mm"
zones = 20
pressure = "2 bar"
density = "1 kg/m^3"
[[region]]
name = "right"
material = "gas"
from = "10 mm"
to = "20 mm"
zones = 20
pressure = "1 bar"
density = "1 kg/m^3"
[material.gas.eos]
law = "ideal_gas"
gamma = 1.4
[output]
report = false
checkpoint_cycles = 10
snapshots = "1 us"
"""
