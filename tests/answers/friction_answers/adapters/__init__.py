"""One module an engine; `template` is the start of a new one."""
