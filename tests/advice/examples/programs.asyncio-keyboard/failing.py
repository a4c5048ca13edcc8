import asyncio
import sys


async def main():
    asyncio.get_running_loop().add_reader(sys.stdin, print)


asyncio.run(main())
