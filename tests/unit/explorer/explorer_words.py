"""The token and the host with which the tests ask."""

TOKEN, HOST = "a" * 32, "127.0.0.1:8123"
