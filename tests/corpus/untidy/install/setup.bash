# made on another machine
